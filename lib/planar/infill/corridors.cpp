#include "infill/corridors.hpp"

#include "geom/disjoint_sets.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/clip.hpp"
#include "polygon/segments.hpp"

#include <algorithm>

namespace filum::infill {

namespace {

using geom::Segment;
using geom::Vec2;
using polygon::Loops;

constexpr double kAtOutline = 0.05; // mm: largest gap that rounding and thinning leave between a cell and its outline
constexpr double kWide = 0.55;      // bead widths to each side: a little more than a bead, so that opening keeps it

bool reaches(const Loops& part, const std::vector<Segment>& outline, const geom::SegmentGrid& grid) {
    return std::any_of(part.points.begin(), part.points.end(), [&](Vec2 p) {
        bool near = false;
        const Vec2 margin{kAtOutline, kAtOutline};
        grid.near(p - margin, p + margin, [&](std::uint32_t i) {
            near = near || geom::point_segment_distance(outline[i].a, outline[i].b, p) < kAtOutline;
        });
        return near;
    });
}

struct Way {
    double length2 = 1e300;
    Vec2 a, b;
    std::size_t to = 0;
};

// The shortest way from one part to a part of another group.
Way nearest(const std::vector<std::vector<Segment>>& sides, std::size_t from, geom::DisjointSets& groups) {
    Way best;
    for (std::size_t to = 0; to < sides.size(); ++to) {
        if (groups.root(static_cast<std::uint32_t>(to)) == groups.root(static_cast<std::uint32_t>(from))) continue;
        const auto corner_to_side = [&](std::size_t corners, std::size_t with) {
            for (const Segment& c : sides[corners])
                for (const Segment& s : sides[with]) {
                    const Vec2 q = geom::nearest_point(s.a, s.b, c.a);
                    const double d = geom::norm2(q - c.a);
                    if (d < best.length2) best = {d, c.a, q, to};
                }
        };
        corner_to_side(from, to);
        corner_to_side(to, from);
    }
    return best;
}

} // namespace

Loops with_corridors(const Loops& cells, const Loops& room, double w) {
    const auto parts = polygon::split(cells).part;
    const auto outline = polygon::segments(room);
    const geom::SegmentGrid grid(outline, w);
    const auto n = static_cast<std::uint32_t>(parts.size());
    geom::DisjointSets groups(n + 1); // the last one: parts that reach the outline
    std::vector<std::vector<Segment>> sides;
    for (std::uint32_t i = 0; i < n; ++i) {
        sides.push_back(polygon::segments(parts[i]));
        if (reaches(parts[i], outline, grid)) groups.unite(i, n);
    }
    Loops added;
    for (std::uint32_t i = 0; i < n; ++i) {
        while (groups.root(i) != groups.root(n)) {
            const Way way = nearest(sides, i, groups);
            if (way.length2 >= 1e300) break;
            const Vec2 line[] = {way.a, way.b};
            const bool point = way.length2 < polygon::kBeadArc * polygon::kBeadArc;
            const Loops corridor = polygon::around(std::span(line).first(point ? 1 : 2), kWide * w, polygon::kBeadArc);
            added.add(corridor);
            groups.unite(i, static_cast<std::uint32_t>(way.to));
        }
    }
    return added.empty() ? cells : polygon::intersect(polygon::unite(cells, added), room);
}

} // namespace filum::infill
