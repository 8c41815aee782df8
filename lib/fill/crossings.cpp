#include "fill/crossings.hpp"

#include "geom/segment.hpp"
#include "geom/segment_grid.hpp"

#include <algorithm>

namespace filum::fill {

std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<toolpath::Curve>& curves,
                                                                    double cell) {
    std::vector<geom::Segment> all;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            all.push_back({c.points[i], c.points[i + 1 == c.points.size() ? 0 : i + 1]});
    const geom::SegmentGrid grid(all, cell);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        const geom::Vec2 a = all[i].a, b = all[i].b;
        grid.near({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                  [&](std::uint32_t j) {
                      if (j > i && geom::cross_properly(a, b, all[j].a, all[j].b)) out.emplace_back(i, j);
                  });
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end()); // a pair may share several cells
    return out;
}

void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes) {
    const auto pairs = crossing_pairs(curves, cell);
    if (pairs.empty()) return;
    std::size_t curve = 0, point = pairs[0].first;
    for (; point >= curves[curve].points.size(); ++curve) point -= curves[curve].points.size();
    const geom::Vec2 at = curves[curve].points[point];
    const auto n = static_cast<double>(pairs.size());
    notes.push_back({"", "curve crosses itself", n, "places", pairs.size(), -1, at.x, at.y});
}

} // namespace filum::fill
