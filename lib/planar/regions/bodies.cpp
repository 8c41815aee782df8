#include "regions/bodies.hpp"

#include "polygon/clip.hpp"
#include "regions/overlaps.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace filum::regions {

namespace {

using polygon::Layer;
using polygon::Loops;
using polygon::Region;

// The bead width of regions with this layer's tool.
Options own(const Options& options, double width) {
    Options out = options;
    if (width > 0) out.bead_width = width;
    return out;
}

// Whether two layers or regions have the same tool and height, so that they may be parts of one region.
bool alike(const auto& a, const auto& b) { return a.tool == b.tool && a.layers == b.layers; }

// The bodies of one tool as one layer.
Layer united(std::span<const Layer* const> bodies) {
    Layer out = *bodies.front();
    for (const Layer* b : bodies.subspan(1)) out.contours = polygon::unite(out.contours, b->contours);
    return out;
}

// Whether the body has area within the region.
bool has_part(const Region& region, const Layer& body) {
    if (body.contours.empty() || !meet(region.box, polygon::bounds(body.contours))) return false;
    return !polygon::intersect(region.loops, body.contours).empty();
}

void set_owner(std::span<Region> regions, std::span<const Layer* const> bodies) {
    for (Region& r : regions) {
        r.tool = bodies.front()->tool;
        r.body = bodies.front()->body;
        r.width = bodies.front()->width;
        r.layers = bodies.front()->layers;
        r.skipped = bodies.front()->skipped;
        if (bodies.size() == 1) continue;
        const auto at = std::find_if(bodies.begin(), bodies.end(), [&](const Layer* b) { return has_part(r, *b); });
        if (at == bodies.end()) continue;
        r.body = (*at)->body;
    }
}

// Sets the parents of regions that lie in holes of regions with another tool: the smallest such region.
void find_parents(std::vector<Region>& regions) {
    for (Region& r : regions) {
        for (const Region& o : regions) {
            if (o.tool == r.tool || o.loops.size() == 1 || !meet(o.box, r.box)) continue;
            for (std::size_t k = 1; k < o.loops.size(); ++k) {
                Loops hole;
                const auto loop = o.loops[k];
                hole.add(std::vector<geom::Vec2>(loop.rbegin(), loop.rend()));
                const Region* now = r.parent < 0 ? nullptr : &regions[static_cast<std::size_t>(r.parent)];
                if (now != nullptr && now->area <= o.area) continue;
                // Outlines may coincide with the hole, so areas decide.
                if (polygon::signed_area(polygon::intersect(hole, r.loops)) > r.area / 2) r.parent = o.id;
            }
        }
    }
}

// The area between bodies of different tools that no bead fits into.
void find_gaps(std::span<const Region> regions, const Options& options, Gaps& gaps) {
    Loops all;
    std::vector<Loops> tools;
    double width = 0;
    for (std::size_t first = 0, last = 0; first < regions.size(); first = last) {
        Loops tool;
        for (; last < regions.size() && regions[last].tool == regions[first].tool; ++last)
            tool.add(regions[last].loops);
        width = std::max(width, own(options, regions[first].width).bead_width);
        tools.push_back(tool);
        all.add(tool);
    }
    all = polygon::unite(all);
    Loops each; // gaps within one tool are not between bodies
    for (const Loops& tool : tools) each.add(polygon::closed(tool, width / 2));
    const Loops narrow = polygon::subtract(polygon::closed(all, width / 2), polygon::unite(each));
    // Corners where bodies meet are filled by closing, too, but are smaller than the dot of a bead.
    const double dot = std::numbers::pi * width * width / 4;
    double height = 0;
    for (const Region& r : regions) height = std::max(height, r.height);
    double largest = 0;
    for (const Loops& gap : polygon::split(polygon::opened(narrow, hairline(options) / 2)).part) {
        const double area = polygon::signed_area(gap);
        if (area < dot) continue;
        gaps.volume += area * height;
        if (area > std::exchange(largest, std::max(largest, area))) gaps.at = gap.points.front();
    }
    if (gaps.volume == 0) return;
    gaps.worst = gaps.volume;
    gaps.layers = 1;
    gaps.layer = regions.front().layer;
}

} // namespace

void Gaps::add(const Gaps& further) {
    volume += further.volume;
    layers += further.layers;
    if (further.worst <= worst) return;
    worst = further.worst;
    layer = further.layer;
    at = further.at;
}

std::vector<Region> body_regions(std::span<const Layer> bodies, const Options& options, Gaps* gaps, Notes& notes) {
    if (bodies.size() == 1) {
        auto out = regions(bodies.front(), own(options, bodies.front().width), notes);
        const Layer* const only = &bodies.front();
        set_owner(out, {&only, 1});
        return out;
    }
    std::vector<const Layer*> by_tool;
    for (const Layer& b : bodies) by_tool.push_back(&b);
    std::stable_sort(by_tool.begin(), by_tool.end(), [](const Layer* a, const Layer* b) {
        return std::pair(a->tool, a->layers) < std::pair(b->tool, b->layers);
    });
    std::vector<Region> out;
    for (std::size_t first = 0, last = 0; first < by_tool.size(); first = last) {
        while (last < by_tool.size() && alike(*by_tool[last], *by_tool[first])) ++last;
        const auto same = std::span(by_tool).subspan(first, last - first);
        const Layer layer = united(same);
        auto found = regions(layer, own(options, layer.width), notes);
        set_owner(found, same);
        const auto id = static_cast<std::uint32_t>(out.size());
        for (Region& r : found) {
            r.id += id;
            if (r.parent >= 0) r.parent += id;
            out.push_back(std::move(r));
        }
    }
    find_parents(out);
    if (gaps != nullptr && !out.empty() && out.front().tool != out.back().tool) find_gaps(out, options, *gaps);
    return out;
}

namespace {

// Calls f(first, count) for each run of regions for which `same` holds.
template <class Same, class Each>
void runs(std::span<const Region> regions, const Same& same, const Each& each) {
    for (std::size_t first = 0, last = 0; first < regions.size(); first = last) {
        while (last < regions.size() && same(regions[last], regions[first])) ++last;
        each(first, last - first);
    }
}

bool same_tool(const Region& a, const Region& b) { return a.tool == b.tool; }

// lay_bodies_on() for regions that are equally many layers high.
void lay_level_on(std::span<Region> upper, const Ground& below, const Options& options, Air& air) {
    const auto one_tool = [](std::span<const Region> r) { return r.empty() || same_tool(r.front(), r.back()); };
    if (one_tool(upper) && one_tool(below.regions) &&
        (upper.empty() || below.regions.empty() || same_tool(upper.front(), below.regions.front())))
        return lay_on(upper, below, own(options, upper.empty() ? 0 : upper.front().width), air);
    std::vector<double> covered(upper.size(), 0);
    runs(upper, same_tool, [&](std::size_t u, std::size_t us) {
        runs(below.regions, same_tool, [&](std::size_t l, std::size_t ls) {
            const Options how = own(options, upper[u].width);
            std::vector<Region> part(upper.begin() + static_cast<long>(u), upper.begin() + static_cast<long>(u + us));
            for (Region& r : part) r.below.clear();
            const auto lower = below.regions.subspan(l, ls);
            const auto area = overlap(part, lower, how.bead_width, hairline(how));
            for (std::size_t i = 0; i < us; ++i) {
                covered[u + i] += area[i];
                for (polygon::Overlap o : part[i].below) {
                    o.link = o.link && same_tool(upper[u], lower.front());
                    upper[u + i].below.push_back(o);
                }
            }
        });
    });
    for (Region& r : upper)
        std::sort(r.below.begin(), r.below.end(), [](const auto& a, const auto& b) { return a.below < b.below; });
    if (!below.bed) hang(upper, below.regions, covered, {options.bead_width, hairline(options)}, air);
}

} // namespace

void lay_bodies_on(std::span<Region> upper, const std::function<Ground(std::int64_t)>& ground, const Options& options,
                   Air& air) {
    const auto same_height = [](const Region& a, const Region& b) { return a.layers == b.layers; };
    runs(upper, same_height, [&](std::size_t first, std::size_t count) {
        lay_level_on(upper.subspan(first, count), ground(upper[first].rests_on()), options, air);
    });
}

std::optional<Note> note(const Gaps& gaps) {
    if (gaps.layers == 0) return std::nullopt;
    return Note{.code = NoteCode::body_gap,
                .amount = gaps.volume,
                .count = gaps.layers,
                .layer = gaps.layer,
                .x = gaps.at.x,
                .y = gaps.at.y};
}

} // namespace filum::regions
