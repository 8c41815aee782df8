#include "metrics/planar/crossings.hpp"

#include "geom/segment_grid.hpp"
#include "toolpath/path.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

using geom::Vec2;

constexpr double kHair = 1e-6;      // of a cell: tolerance of rounding
constexpr double kTouches = 0.5e-3; // mm: a program, which has whole micrometres, cannot express less

// Cells of at least the mean length, at most four per bead; beads on a border belong to both cells.
geom::SegmentGrid grid(std::span<const Bead> beads) {
    std::vector<geom::Segment> segments;
    geom::Box2 box;
    double length = 0;
    for (const Bead& b : beads) {
        segments.push_back({b.a, b.b});
        box.add(b.a);
        box.add(b.b);
        length += geom::distance(b.a, b.b);
    }
    const double n = static_cast<double>(beads.size()), w = box.hi.x - box.lo.x, h = box.hi.y - box.lo.y;
    const double cell = std::max({length / n, std::sqrt(w * h / (4 * n)), (w + h) / (4 * n), 1e-9});
    return {segments, cell, kHair * cell};
}

bool boxes_meet(const Bead& s, const Bead& t) {
    return std::max(s.a.x, s.b.x) >= std::min(t.a.x, t.b.x) && std::max(t.a.x, t.b.x) >= std::min(s.a.x, s.b.x) &&
           std::max(s.a.y, s.b.y) >= std::min(t.a.y, t.b.y) && std::max(t.a.y, t.b.y) >= std::min(s.a.y, s.b.y);
}

// Whether the earlier bead blocks the later one at the crossing of their centre lines, which have these heights there.
bool meet(const Bead& earlier, double top, const Bead& later, double nozzle, double height) {
    const double least = toolpath::kLevel * height;
    if (height == 0 || nozzle < top - least) return true;
    return std::min(top, nozzle) - std::max(top - earlier.thick * height, nozzle - later.thick * height) > least;
}

// Whether ends with these signed distances from a line are on its two sides, neither within kTouches of it.
bool on_both_sides(double a, double b) { return std::min(a, b) < -kTouches && std::max(a, b) > kTouches; }

// Whether they cross; `at` is set to the place.
bool cross(const Bead& s, const Bead& t, double height, Vec2& at) {
    const double s_length = geom::distance(s.a, s.b), t_length = geom::distance(t.a, t.b);
    if (!(s_length > 0 && t_length > 0)) return false;
    const double d1 = geom::orient(s.a, s.b, t.a) / s_length, d2 = geom::orient(s.a, s.b, t.b) / s_length;
    if (!on_both_sides(d1, d2)) return false;
    const double e1 = geom::orient(t.a, t.b, s.a) / t_length, e2 = geom::orient(t.a, t.b, s.b) / t_length;
    if (!on_both_sides(e1, e2)) return false;
    const double u = d1 / (d1 - d2), v = e1 / (e1 - e2);
    at = geom::lerp(t.a, t.b, u);
    const double z_t = std::lerp(double{t.from_z}, t.to_z, u), z_s = std::lerp(double{s.from_z}, s.to_z, v);
    return s.order < t.order ? meet(s, z_s, t, z_t, height) : meet(t, z_t, s, z_s, height);
}

} // namespace

Crossings crossings(std::span<const Bead> beads, std::size_t slots, double height) {
    constexpr std::size_t kPlaces = 16;
    Crossings out;
    out.slot.assign(slots, 0);
    if (beads.size() < 2) return out;
    const geom::SegmentGrid g = grid(beads);
    std::vector<std::pair<std::uint32_t, Vec2>> places;
    for (std::size_t cell = 0; cell < g.cells(); ++cell) {
        const auto in = g.in(cell);
        for (std::size_t j = 1; j < in.size(); ++j)
            for (std::size_t i = 0; i < j; ++i) {
                const Bead &s = beads[in[i]], &t = beads[in[j]];
                Vec2 at;
                if (!boxes_meet(s, t) || std::max(s.order, t.order) - std::min(s.order, t.order) <= 1) continue;
                // each pair once: in the cell of the crossing
                if (!cross(s, t, height, at) || g.cell_at(at) != cell) continue;
                ++out.whole;
                if (s.slot == t.slot) ++out.slot[s.slot];
                places.emplace_back(std::max(s.order, t.order), at);
            }
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    for (std::size_t i = 0; i < std::min(kPlaces, places.size()); ++i) out.place.push_back(places[i].second);
    return out;
}

} // namespace filum::metrics::planar
