#include "metrics/planar/crossings.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

using geom::Vec2;

// A uniform grid over the beads, about as many cells as beads; cell (u, v) holds item[start[c] .. start[c + 1]).
struct Grid {
    Vec2 lo;
    double cell = 1;
    std::int64_t columns = 1, rows = 1;
    std::vector<std::uint32_t> start, item;

    [[nodiscard]] std::int64_t column(double x) const {
        return std::clamp(static_cast<std::int64_t>((x - lo.x) / cell), std::int64_t{0}, columns - 1);
    }
    [[nodiscard]] std::int64_t row(double y) const {
        return std::clamp(static_cast<std::int64_t>((y - lo.y) / cell), std::int64_t{0}, rows - 1);
    }
};

// Calls f(cell) for every cell that the segment passes, give or take a hair.
template <class F>
void for_cells(const Grid& g, const Bead& b, F&& f) {
    const double hair = g.cell * 1e-6;
    const Vec2 p = b.a.y <= b.b.y ? b.a : b.b, q = b.a.y <= b.b.y ? b.b : b.a;
    const std::int64_t r0 = g.row(p.y - hair), r1 = g.row(q.y + hair);
    const double slope = q.y > p.y ? (q.x - p.x) / (q.y - p.y) : 0;
    for (std::int64_t r = r0; r <= r1; ++r) {
        double x0 = p.x, x1 = q.x;
        if (r0 != r1) {
            const double y0 = g.lo.y + static_cast<double>(r) * g.cell - hair, y1 = y0 + g.cell + 2 * hair;
            if (y0 > p.y) x0 = p.x + (y0 - p.y) * slope;
            if (y1 < q.y) x1 = p.x + (y1 - p.y) * slope;
        }
        const std::int64_t c0 = g.column(std::min(x0, x1) - hair), c1 = g.column(std::max(x0, x1) + hair);
        for (std::int64_t c = c0; c <= c1; ++c) f(static_cast<std::size_t>(r * g.columns + c));
    }
}

Grid grid(std::span<const Bead> beads) {
    Grid g;
    geom::Box2 box;
    double length = 0;
    for (const Bead& b : beads) box.add(b.a), box.add(b.b), length += geom::distance(b.a, b.b);
    const double n = static_cast<double>(beads.size());
    const double w = box.hi.x - box.lo.x, h = box.hi.y - box.lo.y;
    g.lo = box.lo;
    // Cells of a mean length or more; never more cells than four per bead.
    g.cell = std::max({length / n, std::sqrt(w * h / (4 * n)), (w + h) / (4 * n), 1e-9});
    g.columns = static_cast<std::int64_t>(w / g.cell) + 1;
    g.rows = static_cast<std::int64_t>(h / g.cell) + 1;
    g.start.assign(static_cast<std::size_t>(g.columns * g.rows) + 1, 0);
    for (const Bead& b : beads) for_cells(g, b, [&](std::size_t c) { ++g.start[c + 1]; });
    for (std::size_t c = 1; c < g.start.size(); ++c) g.start[c] += g.start[c - 1];
    g.item.resize(g.start.back());
    auto at = g.start;
    for (std::uint32_t i = 0; i < beads.size(); ++i)
        for_cells(g, beads[i], [&](std::size_t c) { g.item[at[c]++] = i; });
    return g;
}

bool boxes_meet(const Bead& s, const Bead& t) {
    return std::max(s.a.x, s.b.x) >= std::min(t.a.x, t.b.x) && std::max(t.a.x, t.b.x) >= std::min(s.a.x, s.b.x) &&
           std::max(s.a.y, s.b.y) >= std::min(t.a.y, t.b.y) && std::max(t.a.y, t.b.y) >= std::min(s.a.y, s.b.y);
}

// True if they cross; `at` is where.
bool cross(const Bead& s, const Bead& t, Vec2& at) {
    const double d1 = geom::orient(s.a, s.b, t.a), d2 = geom::orient(s.a, s.b, t.b);
    if (d1 * d2 >= -1e-12) return false;
    if (geom::orient(t.a, t.b, s.a) * geom::orient(t.a, t.b, s.b) >= -1e-12) return false;
    at = geom::lerp(t.a, t.b, d1 / (d1 - d2));
    return true;
}

} // namespace

Crossings crossings(std::span<const Bead> beads, std::size_t slots) {
    constexpr std::size_t kPlaces = 16;
    Crossings out;
    out.slot.assign(slots, 0);
    if (beads.size() < 2) return out;
    const Grid g = grid(beads);
    std::vector<std::pair<std::uint32_t, Vec2>> places;
    for (std::int64_t r = 0; r < g.rows; ++r) {
        for (std::int64_t c = 0; c < g.columns; ++c) {
            const auto cell = static_cast<std::size_t>(r * g.columns + c);
            const std::span<const std::uint32_t> in(g.item.data() + g.start[cell], g.start[cell + 1] - g.start[cell]);
            for (std::size_t j = 1; j < in.size(); ++j) {
                for (std::size_t i = 0; i < j; ++i) {
                    const Bead &s = beads[in[i]], &t = beads[in[j]];
                    Vec2 at;
                    if (!boxes_meet(s, t) || std::max(s.order, t.order) - std::min(s.order, t.order) <= 1) continue;
                    if (!cross(s, t, at) || g.row(at.y) != r || g.column(at.x) != c) continue; // once, where it is
                    ++out.whole;
                    if (s.slot == t.slot) ++out.slot[s.slot];
                    places.emplace_back(std::max(s.order, t.order), at);
                }
            }
        }
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    for (std::size_t i = 0; i < std::min(kPlaces, places.size()); ++i) out.place.push_back(places[i].second);
    return out;
}

} // namespace filum::metrics::planar
