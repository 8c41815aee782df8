// Lines on a plate of 60 x 40 mm, flat or rolled up, through points of the plate.
#pragma once

#include "../../shapes/surface/grid.hpp"
#include "surface/curve/line.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace filum::surfpath {

// A plate of 60 x 40 mm, or rolled up to a part of a cylinder of radius 20 mm.
inline surface::Surface plate(bool rolled) {
    Notes notes;
    return surface::connect(surface::grid(60, 40, 60, 40,
                                          [=](geom::Vec2 p) {
                                              return rolled ? geom::Vec3{20 * std::sin(p.x / 20), p.y,
                                                                         20 * std::cos(p.x / 20)}
                                                            : geom::Vec3{p.x, p.y, 0};
                                          }),
                            notes);
}

// The way of two lines 1 mm apart that a half turn joins.
inline std::vector<geom::Vec2> half_turn_way() {
    std::vector<geom::Vec2> way{{20, 20}, {30, 20}};
    for (int i = 1; i < 30; ++i) {
        const double a = -std::numbers::pi / 2 + std::numbers::pi * i / 30;
        way.push_back({30 + 0.5 * std::cos(a), 20.5 + 0.5 * std::sin(a)});
    }
    way.push_back({30, 21});
    way.push_back({20, 21});
    return way;
}

// The open polyline through points of the plate, with places a tenth of a millimetre apart.
inline surface::curve::Line line_through(const surface::Surface& s, bool rolled, const std::vector<geom::Vec2>& way) {
    using geom::Vec3;
    surface::curve::Line line;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const int n = std::max(1, static_cast<int>(std::ceil(distance(way[i], way[i + 1]) / 0.1)));
        for (int k = 0; k < n || (k == n && i + 2 == way.size()); ++k) {
            const geom::Vec2 p = lerp(way[i], way[i + 1], static_cast<double>(k) / n);
            const auto column = static_cast<std::uint32_t>(p.x), row = static_cast<std::uint32_t>(p.y);
            const bool upper = p.y - row > p.x - column;
            const std::uint32_t t = 2 * (60 * row + column) + (upper ? 1 : 0);
            const Vec3 at = rolled ? Vec3{20 * std::sin(p.x / 20), p.y, 20 * std::cos(p.x / 20)} : Vec3{p.x, p.y, 0};
            line.places.push_back({t, surface::nearest_in(s, t, at)});
        }
    }
    return line;
}

} // namespace filum::surfpath
