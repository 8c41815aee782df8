#include "geom/cubic_turn.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::geom {

std::vector<Vec2> cubic_turn(Vec2 p, Vec2 t, Vec2 q, Vec2 u, double step) {
    const double chord = distance(p, q), c = std::cos(std::acos(std::clamp(dot(t, u), -1.0, 1.0)) / 4);
    const double pull = chord / (3 * c * c);
    const Vec2 p1 = p + pull * t, q1 = q - pull * u;
    const auto n = static_cast<int>(std::max(4.0, std::ceil(std::numbers::pi / 2 * chord / step)));
    std::vector<Vec2> out;
    for (int i = 0; i <= n; ++i) {
        const double f = static_cast<double>(i) / n, g = 1 - f;
        out.push_back(g * g * g * p + 3 * g * g * f * p1 + 3 * g * f * f * q1 + f * f * f * q);
    }
    return out;
}

} // namespace filum::geom
