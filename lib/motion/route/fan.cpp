#include "route/fan.hpp"

#include <algorithm>
#include <cmath>

namespace filum::route {

namespace {

constexpr double kMostRise = 4096, kResolution = 0.05; // mm

Vec3 across(const Vec3& way, const Vec3& axis) {
    Vec3 side = cross(axis, way);
    if (!(norm(side) > 1e-6 * norm(way))) side = cross(axis, std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
    return 1 / norm(side) * side;
}

} // namespace

Fan::Fan(const collision::Room& room, const ToolFrame& from, const ToolFrame& to, std::uint32_t before)
    : room_(&room), chord_{from, to, before}, length_(geom::distance(from.tip, to.tip)), before_(before) {
    side_ = across(to.tip - from.tip, collision::at(chord_, 0.5).axis);
}

ToolFrame Fan::at(const Knot& knot) const {
    const double share = std::clamp(knot.share, 0.0, 1.0);
    ToolFrame out = share == 0 ? chord_.from : share == 1 ? chord_.to : collision::at(chord_, share);
    out.tip =
        out.tip + (knot.share - share) * (chord_.to.tip - chord_.from.tip) + knot.aside * side_ + knot.rise * out.axis;
    return out;
}

std::optional<double> Fan::blocked(const Knot& a, const Knot& b) const {
    return room_->blocked({at(a), at(b), before_});
}

double Fan::least_rise(Knot knot) const {
    if (free(knot)) return knot.rise;
    double low = knot.rise, step = 0.5;
    for (knot.rise += step; knot.rise < kMostRise && !free(knot); knot.rise += step) {
        low = knot.rise;
        step *= 2;
    }
    double high = std::min(knot.rise, kMostRise);
    while (high - low > kResolution) {
        knot.rise = (low + high) / 2;
        (free(knot) ? high : low) = knot.rise;
    }
    return high;
}

double length(const Fan& fan, const Way& way) {
    double sum = 0;
    for (std::size_t i = 1; i < way.size(); ++i) sum += fan.distance(way[i - 1], way[i]);
    return sum;
}

} // namespace filum::route
