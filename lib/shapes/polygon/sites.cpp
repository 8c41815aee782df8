#include "polygon/sites.hpp"

#include "base/error.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace filum::polygon {

namespace {

constexpr double kWidestRegion = 1e5; // mm; twice this must fit a 32-bit integer on the grid

using GridPoint = std::pair<std::int64_t, std::int64_t>;

// The loop on the grid about `origin`, without repeated vertices, straight angles and spikes (edges that turn back).
std::vector<GridPoint> on_grid(std::span<const Vec2> loop, Vec2 origin) {
    std::vector<GridPoint> out;
    const auto straight = [](const GridPoint& a, const GridPoint& b, const GridPoint& c) {
        return (b.first - a.first) * (c.second - b.second) == (b.second - a.second) * (c.first - b.first);
    };
    const auto put = [&](const GridPoint& p) {
        while (out.size() > 1 && straight(out[out.size() - 2], out.back(), p)) out.pop_back();
        if (out.empty() || out.back() != p) out.push_back(p);
    };
    for (const Vec2 p : loop)
        put({std::llround((p.x - origin.x) * kGridPerMm), std::llround((p.y - origin.y) * kGridPerMm)});
    std::size_t first = 0;
    for (bool again = true; again && out.size() > first + 2;) {
        again = true;
        if (out.back() == out[first] || straight(out[out.size() - 2], out.back(), out[first]))
            out.pop_back();
        else if (straight(out.back(), out[first], out[first + 1]))
            ++first;
        else
            again = false;
    }
    out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(first));
    if (out.size() < 3) out.clear();
    return out;
}

Sites on_grid(const Loops& loops, Vec2 origin) {
    Sites out;
    out.origin = origin;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto points = on_grid(loops[l], origin);
        const auto base = static_cast<std::uint32_t>(out.size()), n = static_cast<std::uint32_t>(points.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            out.x.push_back(static_cast<std::int32_t>(points[i].first));
            out.y.push_back(static_cast<std::int32_t>(points[i].second));
            out.next.push_back(base + (i + 1) % n);
            out.prev.push_back(base + (i + n - 1) % n);
        }
    }
    return out;
}

// A grid point below and left of the area, at a distance of the area's larger extent.
Vec2 beside(const Loops& area) {
    const auto box = bounds(area);
    const double size = std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    if (size > kWidestRegion)
        throw Error(Exit::bad_input, "cannot fill a region wider than 100 m; check the unit of the part (--unit)");
    const auto snapped = [](double v) { return std::round(v * kGridPerMm) / kGridPerMm; };
    return {snapped(box.lo.x - size), snapped(box.lo.y - size)};
}

} // namespace

Sites sites_of(const Loops& region, double tolerance) {
    if (region.empty()) return {};
    for (const double share : {1.0, 0.25}) {
        const Loops fewer = simplify(region, share * tolerance);
        if (fewer.size() == region.size() && is_simple(fewer)) return on_grid(fewer, beside(region));
    }
    if (is_simple(region)) return on_grid(region, beside(region));
    for (double by = kGrowBy; by < kGrowAtMost; by *= 4)
        if (Sites out = grown_sites_of(region, by); out.size() > 0) return out;
    return {};
}

Sites grown_sites_of(const Loops& region, double by) {
    const Loops grown = offset(region, by, by);
    return grown.empty() || !is_simple(grown) ? Sites{} : on_grid(grown, beside(grown));
}

Sites turned(const Sites& sites, Vec2 turn) {
    Box2 box;
    for (std::size_t i = 0; i < sites.size(); ++i) box.add(sites.at(i));
    const Vec2 middle = geom::lerp(box.lo, box.hi, 0.5);
    Sites out = sites;
    const Vec2 back = middle.x * turn + middle.y * geom::left_of(turn); // where the middle would be
    out.origin = sites.place(middle - back);
    out.turn = turn.x * sites.turn + turn.y * geom::left_of(sites.turn);
    Loops loops;
    std::vector<char> seen(sites.size(), 0);
    for (std::uint32_t first = 0; first < sites.size(); ++first) {
        if (seen[first]) continue;
        for (std::uint32_t v = first; !seen[v]; v = sites.next[v]) {
            seen[v] = 1;
            const Vec2 p = sites.at(v) - middle;
            const Vec2 q = middle + Vec2{geom::dot(turn, p), geom::cross(turn, p)};
            constexpr double kMost = std::numeric_limits<std::int32_t>::max() - 1.0;
            if (std::max({q.x, q.y, -q.x, -q.y}) > kMost) return {};
            out.x[v] = static_cast<std::int32_t>(std::llround(q.x));
            out.y[v] = static_cast<std::int32_t>(std::llround(q.y));
            loops.points.push_back((1 / kGridPerMm) * out.at(v));
        }
        loops.close();
    }
    return is_simple(loops) ? out : Sites{};
}

} // namespace filum::polygon
