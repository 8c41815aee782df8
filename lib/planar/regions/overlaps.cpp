#include "regions/overlaps.hpp"

#include "geom/disjoint_sets.hpp"
#include "polygon/clip.hpp"
#include "regions/inradius.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filum::regions {

namespace {

using geom::Vec2;
using polygon::Loops;
using polygon::Region;

struct Pair {
    std::uint32_t upper, lower;
};

std::vector<std::uint32_t> by_left_end(std::span<const Region> r) {
    std::vector<std::uint32_t> order(r.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return r[a].box.lo.x < r[b].box.lo.x || (r[a].box.lo.x == r[b].box.lo.x && a < b);
    });
    return order;
}

// The pairs of regions whose boxes meet, by a sweep over x with the open boxes of both sides.
std::vector<Pair> candidates(std::span<const Region> upper, std::span<const Region> lower) {
    const auto us = by_left_end(upper), ls = by_left_end(lower);
    std::vector<std::uint32_t> open_u, open_l;
    std::vector<Pair> out;
    const auto close_until = [](std::vector<std::uint32_t>& open, std::span<const Region> r, double x) {
        std::erase_if(open, [&](std::uint32_t i) { return r[i].box.hi.x < x; });
    };
    std::size_t i = 0, j = 0;
    while (i < us.size() || j < ls.size()) {
        const bool take_upper = j == ls.size() || (i < us.size() && upper[us[i]].box.lo.x <= lower[ls[j]].box.lo.x);
        if (take_upper) {
            const std::uint32_t u = us[i++];
            close_until(open_l, lower, upper[u].box.lo.x);
            for (const auto l : open_l)
                if (meet(upper[u].box, lower[l].box)) out.push_back({u, l});
            open_u.push_back(u);
        } else {
            const std::uint32_t l = ls[j++];
            close_until(open_u, upper, lower[l].box.lo.x);
            for (const auto u : open_u)
                if (meet(upper[u].box, lower[l].box)) out.push_back({u, l});
            open_l.push_back(l);
        }
    }
    return out;
}

// The connected groups of pairs: pairs that share a region are in one group.
std::vector<std::vector<Pair>> groups(const std::vector<Pair>& pairs, std::size_t uppers, std::size_t lowers) {
    geom::DisjointSets sets(uppers + lowers);
    for (const Pair p : pairs) sets.unite(p.upper, static_cast<std::uint32_t>(uppers) + p.lower);
    std::vector<std::vector<Pair>> out;
    std::vector<std::uint32_t> place(sets.size(), ~0U);
    for (const Pair p : pairs) {
        auto& at = place[sets.root(p.upper)];
        if (at == ~0U) {
            at = static_cast<std::uint32_t>(out.size());
            out.emplace_back();
        }
        out[at].push_back(p);
    }
    return out;
}

// The regions of one side of a group. It finds the region of a loop of the common area: by a vertex that the region has
// too, or else by a point inside.
struct Side {
    std::span<const Region> regions;
    std::vector<std::uint32_t> among; // ascending
    struct Vertex {
        Vec2 p;
        std::uint32_t region;
        [[nodiscard]] bool operator<(const Vertex& o) const { return p.x < o.p.x || (p.x == o.p.x && p.y < o.p.y); }
    };
    std::vector<Vertex> vertices; // sorted; empty if there is only one region
    Loops all;
};

Side side(std::span<const Region> regions, std::vector<std::uint32_t> among) {
    std::sort(among.begin(), among.end());
    among.erase(std::unique(among.begin(), among.end()), among.end());
    Side out{regions, std::move(among), {}, {}};
    for (const auto i : out.among)
        for (std::size_t l = 0; l < regions[i].loops.size(); ++l) out.all.add(regions[i].loops[l]);
    if (out.among.size() == 1) return out;
    for (const auto i : out.among)
        for (const Vec2 p : regions[i].loops.points) out.vertices.push_back({p, i});
    std::sort(out.vertices.begin(), out.vertices.end());
    return out;
}

// The region of the side in which `loop`, of the common area, lies; -1 if none. `inside` is a point inside the loop.
int owner(const Side& s, std::span<const Vec2> loop, Vec2 inside) {
    if (s.among.size() == 1) return static_cast<int>(s.among[0]);
    for (const Vec2 p : loop) {
        const auto at = std::lower_bound(s.vertices.begin(), s.vertices.end(), Side::Vertex{p, 0});
        if (at == s.vertices.end() || at->p != p) continue;
        const bool shared = std::next(at) != s.vertices.end() && std::next(at)->p == p; // two regions touch there
        if (!shared) return static_cast<int>(at->region);
    }
    for (const auto i : s.among) {
        const auto& b = s.regions[i].box;
        if (inside.x >= b.lo.x && inside.x <= b.hi.x && inside.y >= b.lo.y && inside.y <= b.hi.y &&
            polygon::contains(s.regions[i].loops, inside))
            return static_cast<int>(i);
    }
    return -1;
}

// A point of the area just inside the longest edge of one of its loops. The loop has the area on its left.
Vec2 just_inside(std::span<const Vec2> loop) {
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (const double d = geom::norm2(loop[(i + 1) % loop.size()] - loop[i]); d > length) {
            length = d;
            longest = i;
        }
    const Vec2 a = loop[longest], b = loop[(longest + 1) % loop.size()];
    return geom::lerp(a, b, 0.5) + (0.0005 / std::max(1e-9, std::sqrt(length))) * geom::left_of(b - a);
}

struct Common {
    std::uint32_t upper, lower;
    Loops loops;
};

// The common areas of a group's pairs; each loop goes to its pair. A loop narrower than 1 um at its longest edge may
// find no pair; its area is practically zero.
std::vector<Common> intersections(std::span<const Region> upper, std::span<const Region> lower,
                                  const std::vector<Pair>& group) {
    std::vector<std::uint32_t> us, ls;
    for (const Pair p : group) {
        us.push_back(p.upper);
        ls.push_back(p.lower);
    }
    const Side above = side(upper, std::move(us)), under = side(lower, std::move(ls));
    const Loops common = polygon::intersect_touching(above.all, under.all);
    std::vector<Common> out;
    for (std::size_t k = 0; k < common.size(); ++k) {
        const Vec2 inside = just_inside(common[k]);
        const int u = owner(above, common[k], inside), l = owner(under, common[k], inside);
        if (u < 0 || l < 0) continue;
        auto at = std::find_if(out.begin(), out.end(), [&](const Common& c) {
            return c.upper == static_cast<std::uint32_t>(u) && c.lower == static_cast<std::uint32_t>(l);
        });
        if (at == out.end()) {
            out.push_back({static_cast<std::uint32_t>(u), static_cast<std::uint32_t>(l), {}});
            at = out.end() - 1;
        }
        at->loops.add(common[k]);
    }
    return out;
}

bool same(const Region& a, const Region& b) {
    return a.loops.start == b.loops.start && a.loops.points == b.loops.points;
}

void add(Region& u, const Region& l, double area, double inradius, double w) {
    const double wanted = std::min(w / 4, std::min(u.inradius, l.inradius) / 2);
    u.below.push_back({l.id, area, inradius, inradius >= wanted});
}

// Records the pairs of equal regions, and removes all pairs of these regions: regions of a layer have no area in
// common, so a region that equals one below lies on no other one.
void take_equal(std::vector<Pair>& pairs, std::span<Region> upper, std::span<const Region> lower, double w,
                std::vector<double>& covered) {
    std::vector<char> upper_done(upper.size(), 0), lower_done(lower.size(), 0);
    for (const Pair p : pairs) {
        Region& u = upper[p.upper];
        if (!same(u, lower[p.lower])) continue;
        covered[p.upper] = u.area;
        add(u, lower[p.lower], u.area, u.inradius, w);
        upper_done[p.upper] = lower_done[p.lower] = 1;
    }
    std::erase_if(pairs, [&](const Pair p) { return upper_done[p.upper] != 0 || lower_done[p.lower] != 0; });
}

} // namespace

std::vector<double> overlap(std::span<Region> upper, std::span<const Region> lower, double w, double hairline) {
    std::vector<double> covered(upper.size(), 0);
    std::vector<Pair> pairs = candidates(upper, lower);
    take_equal(pairs, upper, lower, w, covered);
    for (const auto& group : groups(pairs, upper.size(), lower.size()))
        for (const Common& c : intersections(upper, lower, group)) {
            const double area = polygon::signed_area(c.loops);
            covered[c.upper] += area;
            const double inradius = inradius_bound(c.loops, w / 2, hairline / 2);
            if (inradius > 0) add(upper[c.upper], lower[c.lower], area, inradius, w);
        }
    for (Region& u : upper)
        std::sort(u.below.begin(), u.below.end(), [](const auto& a, const auto& b) { return a.below < b.below; });
    return covered;
}

} // namespace filum::regions
