#include "supports/supports.hpp"

#include "polygon/clip.hpp"
#include "regions/inradius.hpp"
#include "regions/overlaps.hpp"
#include "regions/regions.hpp"
#include "supports/columns.hpp"

#include <algorithm>
#include <cmath>

namespace filum::supports {

namespace {

using polygon::AreaKind;
using polygon::Region;
using polygon::RegionClass;

constexpr double kRound = 0.02;       // mm, of round corners
constexpr double kInterfaceLines = 2; // bead widths from line to line next to the part
constexpr double kSkirtBeads = 2;     // a skirt is as wide: one ring there and back

// Regions by layer.
using Stack = std::vector<std::vector<Region>>;

Stack stack_of(std::vector<Region> regions) {
    Stack out;
    for (Region& r : regions) {
        if (r.layer >= out.size()) out.resize(r.layer + 1);
        out[r.layer].push_back(std::move(r));
    }
    return out;
}

Region made(const Loops& loops, const Region& like, RegionClass is, double bead_width) {
    Region r;
    r.layer = like.layer, r.z = like.z, r.height = like.height;
    r.loops = loops, r.area = polygon::signed_area(loops), r.box = polygon::bounds(loops[0]);
    r.inradius = regions::inradius_bound(loops, bead_width / 2, 1e-3);
    r.is = is, r.walls = 1;
    return r;
}

// The supports of one layer, each filled by a ring and rows.
std::vector<Region> carriers(const Columns& c, std::size_t layer, const Region& like, const Options& o) {
    std::vector<Region> out;
    if (c.all[layer].empty()) return out;
    for (const Loops& part : polygon::split(polygon::simplify(c.all[layer], kRound / 2)).part) {
        Region r = made(part, like, RegionClass::support, o.bead_width);
        if (r.inradius <= 0) continue;
        const Loops inside = polygon::offset(part, -o.bead_width, kRound);
        const Loops near = c.interface[layer].empty() ? Loops{} : polygon::intersect(inside, c.interface[layer]);
        const Loops rest = near.empty() ? inside : polygon::subtract(inside, near);
        const auto put = [&](const Loops& loops, double spacing) {
            if (!loops.empty()) r.areas.push_back({AreaKind::sparse, loops, 0, spacing, polygon::Pattern::rows});
        };
        put(near, std::min(o.spacing, kInterfaceLines * o.bead_width));
        put(rest, o.spacing);
        if (!near.empty()) r.areas.push_back({AreaKind::skin_top, near, 0, 0, {}});
        out.push_back(std::move(r));
    }
    return out;
}

// Adds to each upper region how it lies on lower ones that were not there when the others were found.
void lie_on(std::vector<Region>& upper, std::span<const Region> lower, bool may_link, const Options& o) {
    if (upper.empty() || lower.empty()) return;
    std::vector<Region> probe;
    for (const Region& r : upper) {
        Region p;
        p.loops = r.loops, p.box = r.box, p.inradius = r.inradius, p.area = r.area;
        probe.push_back(std::move(p));
    }
    regions::overlap(probe, lower, o.bead_width, regions::kHairline * o.bead_width);
    for (std::size_t i = 0; i < upper.size(); ++i)
        for (polygon::Overlap found : probe[i].below) {
            found.link = found.link && may_link;
            upper[i].below.push_back(found);
        }
}

// Numbers all regions anew, layer by layer; what they say of each other goes with them.
void renumber(std::vector<Region>& part, std::uint32_t first, std::vector<std::uint32_t>& now) {
    for (Region& r : part) {
        if (r.id >= now.size()) now.resize(r.id + 1, 0);
        now[r.id] = first, r.id = first++;
        for (auto& o : r.below) o.below = now[o.below];
    }
    for (Region& r : part)
        if (r.parent >= 0) r.parent = now[static_cast<std::size_t>(r.parent)];
}

std::vector<Region> rims(const Loops& first, const Region& like, const Options& o) {
    std::vector<Region> out;
    const auto ring = [&](double from, double to) {
        const Loops outer = polygon::offset(first, to, kRound),
                    inner = from > 0 ? polygon::offset(first, from, kRound) : first;
        for (const Loops& part : polygon::split(polygon::subtract(outer, inner)).part)
            if (Region r = made(part, like, RegionClass::rim, o.bead_width); r.inradius > 0)
                out.push_back(std::move(r));
    };
    if (o.brim > 0) ring(0, o.brim);
    if (o.skirt > 0) ring(o.brim + o.skirt, o.brim + o.skirt + kSkirtBeads * o.bead_width);
    return out;
}

// The overhangs that nothing carries.
void tell_bare(const std::vector<Loops>& over, const Columns& c, const Stack& stack, const Options& o, Notes& notes) {
    Note bare{"", "overhang not carried", 0, "mm2", 0};
    const auto below = static_cast<std::size_t>(o.gap) + 1;
    for (std::size_t i = below; i < over.size(); ++i) {
        if (over[i].empty() || stack[i].empty()) continue;
        const Loops left =
            polygon::offset(polygon::subtract(over[i], c.all[i - below]), -o.beside - o.bead_width, kRound);
        if (left.empty()) continue;
        bare.amount += polygon::signed_area(polygon::offset(left, o.beside + o.bead_width, kRound)), ++bare.count;
        bare.layer = static_cast<std::int64_t>(i), bare.x = left.points[0].x, bare.y = left.points[0].y;
    }
    if (bare.count > 0) notes.push_back(bare);
}

} // namespace

std::vector<Region> supports(std::vector<Region> regions, const Options& o, Facts& facts, Notes& notes) {
    const auto layers = materials(regions);
    Stack stack = stack_of(std::move(regions)), added(stack.size());
    if (o.support) {
        std::vector<double> height(stack.size(), 0);
        for (std::size_t i = 0; i < stack.size(); ++i)
            if (!stack[i].empty()) height[i] = stack[i][0].height;
        const auto over = overhangs(layers, height, o);
        const Columns c = columns(layers, over, o);
        for (std::size_t i = 0; i < stack.size(); ++i)
            if (!stack[i].empty()) added[i] = carriers(c, i, stack[i][0], o);
        tell_bare(over, c, stack, o, notes);
    }
    if (!stack.empty() && !stack[0].empty())
        for (Region& r : rims(layers[0], stack[0][0], o)) added[0].push_back(std::move(r));
    std::vector<std::uint32_t> now;
    std::vector<Region> out;
    std::uint32_t id = 0;
    double area = 0;
    for (std::size_t i = 0; i < stack.size(); ++i) {
        renumber(stack[i], id, now);
        id += static_cast<std::uint32_t>(stack[i].size());
        for (Region& r : added[i]) r.id = id++, area += r.is == RegionClass::support ? r.area * r.height : 0;
        const std::size_t far = static_cast<std::size_t>(o.gap) + 1;
        if (i > 0) lie_on(added[i], added[i - 1], true, o);
        if (i >= far) {
            lie_on(stack[i], added[i - far], false, o); // the part on supports
            lie_on(added[i], stack[i - far], false, o); // supports on the part
        }
        for (Region& r : stack[i]) out.push_back(r);
        for (Region& r : added[i]) out.push_back(r);
    }
    facts.push_back({"", "support-space", area, "mm3"});
    return out;
}

} // namespace filum::supports
