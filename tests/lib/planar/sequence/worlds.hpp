// Small worlds for the tests of sequence, and what plain enumeration says about them.
#pragma once

#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "sequence/collision.hpp"
#include "sequence/order.hpp"
#include "sequence/sequence.hpp"

#include <algorithm>
#include <bit>
#include <random>

namespace filum::sequence {

using Random = std::mt19937;

inline constexpr std::uint64_t kAmple = 50'000'000; // work

inline double uniform(Random& random, double lo, double hi) { return lo + (hi - lo) * (random() / 4294967295.0); }

// One of least ... most.
inline Index any(Random& random, Index least, Index most) {
    return least + static_cast<Index>(random() % (most - least + 1));
}

inline double fact(const SequenceResult& r, const std::string& name) {
    for (const auto& f : r.facts)
        if (f.name == name) return f.value;
    return -1;
}

inline polygon::Loops box(double x, double y, double w, double h) {
    polygon::Loops out;
    out.add(std::vector<geom::Vec2>{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}});
    return out;
}

struct Outlined {
    std::uint32_t layer;
    polygon::Loops loops;
};

// Regions with all their overlaps, as `regions` would write them; h = 0.2 mm.
inline std::vector<polygon::Region> world(const std::vector<Outlined>& outlined) {
    std::vector<polygon::Region> out;
    for (const auto& o : outlined) {
        polygon::Region r;
        r.id = static_cast<std::uint32_t>(out.size());
        r.layer = o.layer;
        r.z = 0.2 * (o.layer + 1);
        r.height = 0.2;
        r.loops = o.loops;
        r.area = polygon::signed_area(r.loops);
        r.box = polygon::bounds(r.loops);
        for (const auto& u : out) {
            if (u.layer + 1 != r.layer) continue;
            const double a = polygon::signed_area(polygon::intersect(u.loops, r.loops));
            if (a > 1e-3) r.below.push_back({u.id, a, 0.2, a > 0.05});
        }
        out.push_back(std::move(r));
    }
    return out;
}

// `layers` layers of up to `most` boxes each that grow on, split, merge and lean at random, in a field of `size` mm.
inline std::vector<polygon::Region> random_world(Random& random, std::uint32_t layers, int most, double size) {
    std::vector<Outlined> out;
    std::vector<polygon::Loops> below;
    for (std::uint32_t l = 0; l < layers; ++l) {
        polygon::Loops soup;
        for (int i = 0; i < most; ++i) {
            geom::Vec2 at{uniform(random, 0, size), uniform(random, 0, size)};
            if (l > 0 && random() % 4 != 0) {
                const auto& b = below[random() % below.size()];
                at = geom::lerp(polygon::bounds(b).lo, polygon::bounds(b).hi, uniform(random, 0, 0.5));
            }
            const geom::Vec2 sides{uniform(random, 0.3, 1.5), uniform(random, 0.3, 1.5)};
            const auto b = box(at.x, at.y, sides.x, sides.y);
            soup.add(b[0]);
        }
        below = polygon::split(soup).part;
        for (const auto& b : below) out.push_back({l, b});
    }
    return world(out);
}

// k equal columns of `layers` regions, each in the others' way from a height of c layers on.
struct Towers {
    Graph g;
    Columns columns;
    std::vector<Pair> collisions;
};
inline Towers towers(Index k, Index layers, Index c) {
    Towers t;
    std::vector<Pair> links;
    for (Index l = 0; l < layers; ++l)
        for (Index i = 0; i < k; ++i) {
            t.g.node.push_back({l, 0.2 * l, {10.0 * i, 0}});
            if (l > 0) links.emplace_back((l - 1) * k + i, l * k + i);
            for (Index j = 0; j < k; ++j)
                if (j != i && l + c < layers) t.collisions.emplace_back(l * k + i, (l + c) * k + j);
            if (l == 0) t.columns.member.emplace_back();
            t.columns.member[i].push_back(l * k + i);
            t.columns.of.push_back(i);
        }
    t.g.up = arcs(t.g.size(), links);
    t.g.down = reversed(t.g.up);
    t.g.after = arcs(t.g.size(), links);
    t.g.before = reversed(t.g.after);
    add_precedence(t.g, t.collisions);
    return t;
}

// How many, in braces: those are drawn in the order they are written.
struct Extent {
    Index columns, layers, most;
};

// Columns of up to `layers` regions, each pair in each other's way from its own height of up to `most` layers on, or
// not at all; some steps of a column are no links, and some links lead to other columns.
inline Towers random_towers(Random& random, const Extent& extent) {
    const auto [k, layers, most] = extent;
    Towers t;
    std::vector<Pair> links, support;
    std::vector<std::vector<Index>> at(k, std::vector<Index>(layers, kNone));
    std::vector<Index> lowest(k), end(k);
    t.columns.member.resize(k);
    for (Index i = 0; i < k; ++i) {
        lowest[i] = i == 0 ? 0 : static_cast<Index>(random() % layers);
        end[i] = i == 0 ? layers : lowest[i] + 1 + static_cast<Index>(random() % (layers - lowest[i]));
    }
    for (Index l = 0; l < layers; ++l)
        for (Index i = 0; i < k; ++i) {
            if (l < lowest[i] || l >= end[i]) continue;
            const Index v = at[i][l] = t.g.size();
            t.g.node.push_back({l, 0.2 * l, {10.0 * i, 0}});
            t.columns.member[i].push_back(v);
            t.columns.of.push_back(i);
            for (Index j = 0; j < k && l > 0; ++j) {
                const Index u = at[j][l - 1];
                if (u == kNone || (j != i && random() % 20 != 0)) continue;
                support.emplace_back(u, v);
                if (random() % 10 != 0) links.emplace_back(u, v);
            }
        }
    for (Index i = 0; i < k; ++i)
        for (Index j = 0; j < k; ++j) {
            const Index c = 1 + static_cast<Index>(random() % most);
            if (i == j || random() % 6 == 0) continue;
            for (Index l = lowest[i]; l < end[i]; ++l)
                if (l + c >= lowest[j] && l + c < end[j]) t.collisions.emplace_back(at[i][l], at[j][l + c]);
        }
    t.g.up = arcs(t.g.size(), links);
    t.g.down = reversed(t.g.up);
    t.g.after = arcs(t.g.size(), support);
    t.g.before = reversed(t.g.after);
    add_precedence(t.g, t.collisions);
    return t;
}

// The fewest strokes by enumeration of all (printed set, last region); for up to about 16 regions.
inline Index fewest_strokes(const Graph& g) {
    const Index n = g.size();
    std::vector<std::uint32_t> before(n, 0);
    for (Index v = 0; v < n; ++v)
        for (const Index u : g.before[v]) before[v] |= 1U << u;
    std::vector<std::uint8_t> least((std::size_t{1} << n) * n, 255);
    for (Index v = 0; v < n; ++v)
        if (before[v] == 0) least[(std::size_t{1} << v) * n + v] = 1;
    for (std::size_t set = 1; set < std::size_t{1} << n; ++set)
        for (Index u = 0; u < n; ++u) {
            const auto so_far = least[set * n + u];
            if (so_far == 255) continue;
            for (Index v = 0; v < n; ++v) {
                if ((set >> v & 1) != 0 || (before[v] & ~set) != 0) continue;
                auto& to = least[(set | std::size_t{1} << v) * n + v];
                to = std::min<std::uint8_t>(to, static_cast<std::uint8_t>(so_far + (continues(g, u, v) ? 0 : 1)));
            }
        }
    const std::size_t all = (std::size_t{1} << n) - 1;
    return *std::min_element(least.begin() + static_cast<long>(all * n), least.end());
}

// Plain distances between two regions: of their outlines, and whether one holds a point of the other.
inline bool overlap(const polygon::Loops& a, const polygon::Loops& b) {
    return polygon::signed_area(polygon::intersect(a, b)) > 0;
}
inline double plain_distance(const polygon::Loops& a, const polygon::Loops& b) {
    if (overlap(a, b)) return 0;
    double best = 1e300;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a[i].size(); ++k)
            for (std::size_t j = 0; j < b.size(); ++j)
                for (std::size_t l = 0; l < b[j].size(); ++l)
                    best = std::min(best, geom::segment_distance(a[i][k], a[i][(k + 1) % a[i].size()], b[j][l],
                                                                 b[j][(l + 1) % b[j].size()]));
    return best;
}

// True if the head over v touches u, by the rule itself: disc by distance, box by growing v.  NaN-free margins of 1 nm
// are left to both sides.
inline bool plainly_collides(const polygon::Region& v, const polygon::Region& u, const machine::Head& head) {
    const double dz = u.z - v.z;
    if (dz <= 0 || head.none) return false;
    if (dz > head.gantry_height + 1e-6) return true;
    if (plain_distance(v.loops, u.loops) < head.cone_radius(dz) - 1e-6) return true;
    if (dz <= head.cone_height + 1e-6) return false;
    polygon::Loops grown; // v swept by the carriage: the hulls of its edges' boxes, and itself
    const double x = head.carriage_x / 2 - 1e-3, y = head.carriage_y / 2 - 1e-3;
    for (const auto p : v.loops.points) grown.add(box(p.x - x, p.y - y, 2 * x, 2 * y)[0]);
    return overlap(polygon::unite(grown), u.loops);
}

} // namespace filum::sequence
