#include "supports/supports.hpp"

#include "base/density.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"
#include "regions/air.hpp"
#include "regions/inradius.hpp"
#include "regions/overlaps.hpp"
#include "regions/regions.hpp"
#include "supports/columns.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace filum::supports {

namespace {

using polygon::AreaKind;
using polygon::kBeadArc;
using polygon::Region;
using polygon::RegionClass;

constexpr double kInterfaceLines = 2; // bead widths between lines next to the part
constexpr double kRaftReach = 2;  // bead widths beyond the part: one ring, and a place for the outer bead to rest on
constexpr double kTouch = 1e-3;   // mm: outlines nearer than this touch
constexpr double kSkirtBeads = 2; // beads, width of a skirt: one ring, there and back

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

// The regions of both stacks, layer by layer; in each layer those of `first` come first.
std::vector<Region> flattened(Stack first, Stack second) {
    std::vector<Region> out;
    for (std::size_t i = 0; i < first.size(); ++i)
        for (auto* from : {&first[i], &second[i]})
            out.insert(out.end(), std::make_move_iterator(from->begin()), std::make_move_iterator(from->end()));
    return out;
}

// A region with beads `width` mm wide.
Region made(const Loops& loops, const Region& like, RegionClass is, double width, const Options& o) {
    Region r;
    if (width != o.bead_width) r.width = width;
    r.layer = like.layer;
    r.z = like.z;
    r.height = like.height;
    r.loops = loops;
    r.area = polygon::signed_area(loops);
    r.box = polygon::bounds(loops[0]);
    r.inradius = regions::inradius_bound(loops, width / 2, 1e-3);
    r.is = is;
    r.walls = 1;
    return r;
}

// The first layer with any region.
std::size_t first_of(const Stack& stack) {
    std::size_t i = 0;
    while (i < stack.size() && stack[i].empty()) ++i;
    return i;
}

// A region with the number, z and height of a layer. Layers below the first one of the part are as high as that one.
// The height is 0 if there is no layer to copy.
Region model(const Stack& stack, std::size_t layer) {
    const std::size_t first = first_of(stack), from = stack[layer].empty() ? std::max(first, layer) : layer;
    Region out;
    if (from >= stack.size() || stack[from].empty()) return out;
    out.layer = static_cast<std::uint32_t>(layer);
    out.height = stack[from][0].height;
    out.z = stack[from][0].z - static_cast<double>(from - layer) * out.height;
    if (from == layer) out.width = stack[from][0].width;
    return out;
}

// Raises the regions, and the wanted and unwanted areas, by `by` layers.
void raise(std::vector<Region>& regions, Options& o, std::uint32_t by) {
    if (regions.empty()) return;
    for (auto* places : {&o.wanted, &o.unwanted})
        if (!places->empty()) places->insert(places->begin(), by, {});
    const double up = by * regions[0].height;
    for (Region& r : regions) {
        r.layer += by;
        r.z += up;
    }
}

// The supports of one layer, each filled by a ring and rows.
std::vector<Region> carriers(const Columns& c, std::size_t layer, const Region& like, const Options& o) {
    std::vector<Region> out;
    if (c.all[layer].empty()) return out;
    for (const Loops& part : polygon::split(polygon::simplify(c.all[layer], kBeadArc)).part) {
        const double w = layer == 0 && like.width > 0 ? like.width : o.own_width(); // mm; that of a first layer counts
        Region r = made(part, like, RegionClass::support, w, o);
        if (r.inradius <= 0) continue;
        const Loops inside = polygon::offset(part, -w, kBeadArc);
        const Loops near = c.interface[layer].empty() ? Loops{} : polygon::intersect(inside, c.interface[layer]);
        const Loops rest = near.empty() ? inside : polygon::subtract(inside, near);
        const auto put = [&](const Loops& loops, double spacing) {
            if (!loops.empty()) r.areas.push_back({AreaKind::sparse, loops, 0, spacing, polygon::InfillPattern::rows});
        };
        put(near, std::min(o.spacing, kInterfaceLines * w));
        put(rest, o.spacing);
        if (!near.empty()) r.areas.push_back({AreaKind::skin_top, near, 0, 0, {}});
        out.push_back(std::move(r));
    }
    return out;
}

// All overhangs, including those in wanted areas and without unwanted areas.
std::vector<Loops> all_overhangs(const std::vector<Loops>& layers, const std::vector<double>& height,
                                 const Options& o) {
    std::vector<Loops> out(layers.size());
    if (o.support) out = overhangs(layers, height, o);
    if (!o.wanted.empty()) {
        Options any = o;
        any.angle = 0;
        const auto all = overhangs(layers, height, any);
        for (std::size_t i = 0; i < std::min(out.size(), o.wanted.size()); ++i)
            if (!all[i].empty() && !o.wanted[i].empty())
                out[i] = polygon::unite(out[i], polygon::intersect(all[i], o.wanted[i]));
    }
    for (std::size_t i = 0; i < std::min(out.size(), o.unwanted.size()); ++i)
        if (!out[i].empty() && !o.unwanted[i].empty()) out[i] = polygon::subtract(out[i], o.unwanted[i]);
    return out;
}

// The supports of all layers. A raft is the support of the whole first layer.
Stack all_carriers(const std::vector<Loops>& layers, const Stack& stack, const Options& o) {
    std::vector<double> height(stack.size(), 0);
    for (std::size_t i = 0; i < stack.size(); ++i) height[i] = model(stack, i).height;
    std::vector<Loops> over = all_overhangs(layers, height, o);
    if (const std::size_t first = first_of(stack); o.raft > 0 && first < stack.size())
        over[first] = polygon::offset(layers[first], kRaftReach * o.bead_width, kBeadArc);
    const Columns c = columns(layers, height, over, o);
    Stack out(stack.size());
    for (std::size_t i = 0; i < stack.size(); ++i)
        if (const Region like = model(stack, i); like.height > 0) out[i] = carriers(c, i, like, o);
    return out;
}

// Adds to each upper region its overlaps with lower regions that did not exist when the other overlaps were found. No
// region lies on a brim, which only shares the outline that it surrounds.
void lie_on(std::vector<Region>& upper, std::vector<Region> lower, bool may_link, const Options& o) {
    std::erase_if(lower, [](const Region& r) { return r.is == RegionClass::rim; });
    if (upper.empty() || lower.empty()) return;
    std::vector<Region> probe;
    for (const Region& r : upper) {
        Region p;
        p.loops = r.loops;
        p.box = r.box;
        p.inradius = r.inradius;
        p.area = r.area;
        probe.push_back(std::move(p));
    }
    regions::overlap(probe, lower, o.bead_width, regions::kHairline * o.bead_width);
    for (std::size_t i = 0; i < upper.size(); ++i)
        for (polygon::Overlap found : probe[i].below) {
            found.link = found.link && may_link;
            upper[i].below.push_back(found);
        }
}

// Numbers the regions of a layer from `first`, and updates the ids by which they refer to others. `now` maps old ids to
// new.
void renumber(std::vector<Region>& part, std::uint32_t first, std::unordered_map<std::int64_t, std::uint32_t>& now) {
    for (Region& r : part) {
        now[r.id] = first;
        r.id = first++;
        for (auto& o : r.below) o.below = now.at(o.below);
    }
    for (Region& r : part)
        for (std::int64_t* other : {&r.parent, &r.brim})
            if (*other >= 0) *other = now.at(*other);
}

// The brim and the skirt of the first layer. They lie outside only: in holes they would be hard to remove.
std::vector<Region> rims(const Loops& first, const Region& like, const Options& o) {
    Loops outer;
    for (const Loops& part : polygon::split(first).part) outer.add(part[0]);
    const Loops whole = polygon::unite(outer);
    const double w = like.width > 0 ? like.width : o.bead_width;
    std::vector<Region> out;
    const auto ring = [&](double from, double to) {
        const Loops inner = from > 0 ? polygon::offset(whole, from, kBeadArc) : whole;
        for (const Loops& part : polygon::split(polygon::subtract(polygon::offset(whole, to, kBeadArc), inner)).part)
            if (Region r = made(part, like, RegionClass::rim, w, o); r.inradius > 0) out.push_back(std::move(r));
    };
    if (o.brim > 0) ring(0, o.brim);
    if (o.skirt > 0) ring(o.brim + o.skirt, o.brim + o.skirt + kSkirtBeads * w);
    return out;
}

// True if the first point of the region lies on the outline of the brim.
bool about(const Region& brim, const Region& region) {
    const geom::Vec2 p = region.loops[0][0];
    for (const geom::Segment& s : polygon::segments(brim.loops))
        if (geom::point_segment_distance(s.a, s.b, p) < kTouch) return true;
    return false;
}

// Sets Region::brim of the regions of the first layer: the brim in `added` that surrounds each.
void tell_brims(std::vector<Region>& first, const std::vector<Region>& added) {
    for (Region& r : first)
        for (const Region& rim : added)
            if (r.is != RegionClass::rim && rim.is == RegionClass::rim && about(rim, r)) r.brim = rim.id;
}

// Sets the part of each upper region that hangs: farther than half a bead from the layer below and, across the gap,
// from the supports there. Their overlaps give the area that is carried.
void hang_anew(std::vector<Region>& upper, const std::vector<Region>& below, const std::vector<Region>& across,
               const Options& o, regions::Air& air) {
    std::vector<double> covered;
    for (const Region& r : upper) {
        covered.push_back(0);
        for (const polygon::Overlap& on : r.below) covered.back() += on.area;
    }
    std::vector<Region> lower = below;
    lower.insert(lower.end(), across.begin(), across.end());
    regions::hang(upper, lower, covered, {o.bead_width, regions::kHairline * o.bead_width}, air);
}

// Sets the parts of the model that still hang, and adds a note. The first layer lies on the bed or the raft.
void tell_hanging(Stack& stack, const Stack& added, const Options& o, Notes& notes) {
    const std::size_t far = static_cast<std::size_t>(o.gap) + 1;
    regions::Air air;
    for (std::size_t i = first_of(stack) + (o.raft > 0 ? 0 : 1); i < stack.size(); ++i)
        hang_anew(stack[i], stack[i - 1], i < far ? std::vector<Region>{} : added[i - far], o, air);
    if (const auto said = regions::note(air)) notes.push_back(*said);
}

} // namespace

std::vector<Region> supports(std::vector<Region> regions, const Options& options, Facts& facts, Notes& notes) {
    Options o = options;
    for (const Region& r : regions)
        check_density(polygon::signed_area(r.loops), o.bead_width, Exit::usage, "--bead-width");
    if (o.carries()) check_spacing(o.spacing, o.own_width(), Exit::usage, "--support-spacing");
    if (o.raft > 0) raise(regions, o, static_cast<std::uint32_t>(o.raft + o.gap));
    const auto layers = polygon::materials(regions);
    Stack stack = stack_of(std::move(regions)), added(stack.size());
    if (o.carries()) added = all_carriers(layers, stack, o);
    if (!stack.empty()) {
        Loops first = layers[0]; // and the supports that stand beside it on the bed
        for (const Region& r : added[0]) first.add(r.loops);
        for (Region& r : rims(first, model(stack, 0), o)) added[0].push_back(std::move(r));
    }
    std::unordered_map<std::int64_t, std::uint32_t> now;
    std::uint32_t id = 0;
    double area = 0;
    for (std::size_t i = 0; i < stack.size(); ++i) {
        renumber(stack[i], id, now);
        id += static_cast<std::uint32_t>(stack[i].size());
        for (Region& r : added[i]) {
            r.id = id++;
            if (r.is == RegionClass::support) area += r.area * r.height;
        }
        if (i == 0) {
            tell_brims(stack[0], added[0]);
            tell_brims(added[0], added[0]); // the brim of a raft
        }
        const std::size_t far = static_cast<std::size_t>(o.gap) + 1;
        if (i > 0) lie_on(added[i], added[i - 1], true, o);
        if (i >= far) {
            lie_on(stack[i], added[i - far], false, o); // the part on supports
            lie_on(added[i], stack[i - far], false, o); // supports on the part
        }
    }
    if (o.carries()) tell_hanging(stack, added, o, notes);
    facts.push_back({"", "support-space", area, "mm3"});
    return flattened(std::move(stack), std::move(added));
}

} // namespace filum::supports
