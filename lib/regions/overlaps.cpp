#include "regions/overlaps.hpp"

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

constexpr double kLeastArea = 1e-6; // mm2; below is rounding
constexpr double kLeastRadius = 0.005;

struct Pair {
    std::uint32_t upper, lower;
};

bool meet(const geom::Box2& a, const geom::Box2& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

std::vector<std::uint32_t> by_left_end(std::span<const Region> r) {
    std::vector<std::uint32_t> order(r.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return r[a].box.lo.x < r[b].box.lo.x || (r[a].box.lo.x == r[b].box.lo.x && a < b);
    });
    return order;
}

// Pairs whose boxes meet, by a sweep over x with the open boxes of both sides.
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

std::uint32_t root(std::vector<std::uint32_t>& up, std::uint32_t i) {
    while (up[i] != i) i = up[i] = up[up[i]];
    return i;
}

// The groups of pairs that hang together.
std::vector<std::vector<Pair>> groups(const std::vector<Pair>& pairs, std::size_t uppers, std::size_t lowers) {
    std::vector<std::uint32_t> up(uppers + lowers);
    std::iota(up.begin(), up.end(), 0U);
    for (const Pair p : pairs) {
        const auto a = root(up, p.upper), b = root(up, static_cast<std::uint32_t>(uppers) + p.lower);
        up[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::vector<Pair>> out;
    std::vector<std::uint32_t> place(up.size(), ~0U);
    for (const Pair p : pairs) {
        auto& at = place[root(up, p.upper)];
        if (at == ~0U) at = static_cast<std::uint32_t>(out.size()), out.emplace_back();
        out[at].push_back(p);
    }
    return out;
}

// The region of a group that a point lies in; -1 if none.
int owner(std::span<const Region> regions, const std::vector<std::uint32_t>& among, Vec2 p) {
    for (const auto i : among) {
        const auto& b = regions[i].box;
        if (p.x >= b.lo.x && p.x <= b.hi.x && p.y >= b.lo.y && p.y <= b.hi.y && polygon::contains(regions[i].loops, p))
            return static_cast<int>(i);
    }
    return -1;
}

// A point of the area just inside the longest edge of one of its loops (which has the area on its left).
Vec2 just_inside(std::span<const Vec2> loop) {
    std::size_t longest = 0;
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (const double d = geom::norm2(loop[(i + 1) % loop.size()] - loop[i]); d > length) length = d, longest = i;
    const Vec2 a = loop[longest], b = loop[(longest + 1) % loop.size()];
    return geom::lerp(a, b, 0.5) + (0.0005 / std::max(1e-9, std::sqrt(length))) * geom::left_of(b - a);
}

struct Common {
    std::uint32_t upper, lower;
    Loops loops;
};

void sort_unique(std::vector<std::uint32_t>& v) {
    std::sort(v.begin(), v.end());
    v.erase(std::unique(v.begin(), v.end()), v.end());
}

// The common areas of a group's pairs, each loop given to the pair that it belongs to.  A loop narrower than 1 um at
// its longest edge may find no owner: its area is nil.
std::vector<Common> intersections(std::span<const Region> upper, std::span<const Region> lower,
                                  const std::vector<Pair>& group) {
    std::vector<std::uint32_t> us, ls;
    for (const Pair p : group) us.push_back(p.upper), ls.push_back(p.lower);
    sort_unique(us);
    sort_unique(ls);
    const auto all = [](std::span<const Region> r, const std::vector<std::uint32_t>& among) {
        Loops out;
        for (const auto i : among)
            for (std::size_t l = 0; l < r[i].loops.size(); ++l) out.add(r[i].loops[l]);
        return out;
    };
    const Loops common = polygon::intersect(all(upper, us), all(lower, ls));
    std::vector<Common> out;
    for (std::size_t k = 0; k < common.size(); ++k) {
        int u = static_cast<int>(us[0]), l = static_cast<int>(ls[0]);
        if (us.size() > 1 || ls.size() > 1) {
            const Vec2 p = just_inside(common[k]);
            if (us.size() > 1) u = owner(upper, us, p);
            if (ls.size() > 1) l = owner(lower, ls, p);
        }
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
    u.below.push_back({l.id, area, inradius, inradius > 0 && inradius >= wanted});
}

} // namespace

void overlap(std::span<Region> upper, std::span<const Region> lower, double w) {
    for (const auto& group : groups(candidates(upper, lower), upper.size(), lower.size())) {
        if (group.size() == 1 && same(upper[group[0].upper], lower[group[0].lower])) {
            Region& u = upper[group[0].upper];
            add(u, lower[group[0].lower], u.area, u.inradius, w);
            continue;
        }
        for (const Common& c : intersections(upper, lower, group)) {
            const double area = polygon::signed_area(c.loops);
            if (area < kLeastArea) continue;
            add(upper[c.upper], lower[c.lower], area, inradius_bound(c.loops, w / 2, kLeastRadius), w);
        }
    }
    for (Region& u : upper) {
        std::sort(u.below.begin(), u.below.end(), [](const auto& a, const auto& b) { return a.below < b.below; });
        double covered = 0;
        for (const auto& o : u.below) covered += o.area;
        u.unsupported = std::max(0.0, u.area - covered);
    }
}

} // namespace filum::regions
