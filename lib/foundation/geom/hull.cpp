#include "geom/hull.hpp"

#include <algorithm>

namespace filum::geom {

std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end());
    const auto before = [](const Vec2& a, const Vec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    std::sort(sorted.begin(), sorted.end(), before);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Vec2> out;
    // The lower side from left to right, then the upper side from right to left.
    const auto pass = [&](auto from, auto to) {
        const std::size_t first = out.size();
        for (auto p = from; p != to; ++p) {
            while (out.size() >= first + 2 && cross(out.back() - out[out.size() - 2], *p - out.back()) <= 0)
                out.pop_back();
            out.push_back(*p);
        }
        out.pop_back(); // the other pass begins with this point
    };
    pass(sorted.begin(), sorted.end());
    pass(sorted.rbegin(), sorted.rend());
    return out;
}

} // namespace filum::geom
