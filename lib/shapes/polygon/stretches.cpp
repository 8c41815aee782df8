#include "polygon/stretches.hpp"

#include <algorithm>
#include <cmath>

namespace filum::polygon {

void rotate(std::vector<Vec2>& points, double angle) {
    if (angle == 0) return;
    const Vec2 x{std::cos(angle), std::sin(angle)}, y = geom::left_of(x);
    for (Vec2& p : points) p = p.x * x + p.y * y;
}

Loops rotated(const Loops& loops, double angle) {
    Loops out = loops;
    rotate(out.points, angle);
    return out;
}

std::vector<std::vector<LevelStretch>> scan(const Loops& area, const std::vector<double>& y) {
    std::vector<std::vector<double>> cuts(y.size());
    for (std::size_t i = 0; i < area.size(); ++i) {
        const auto loop = area[i];
        for (std::size_t j = 0, k = loop.size() - 1; j < loop.size(); k = j++) {
            const Vec2 a = loop[k].y < loop[j].y ? loop[k] : loop[j], b = loop[k].y < loop[j].y ? loop[j] : loop[k];
            for (auto r = std::lower_bound(y.begin(), y.end(), a.y); r != y.end() && *r < b.y; ++r)
                cuts[static_cast<std::size_t>(r - y.begin())].push_back(a.x + (b.x - a.x) * (*r - a.y) / (b.y - a.y));
        }
    }
    std::vector<std::vector<LevelStretch>> out(y.size());
    for (std::size_t r = 0; r < y.size(); ++r) {
        std::sort(cuts[r].begin(), cuts[r].end());
        for (std::size_t i = 0; i + 1 < cuts[r].size(); i += 2) out[r].push_back({cuts[r][i], cuts[r][i + 1]});
    }
    return out;
}

} // namespace filum::polygon
