#include "collision/shape.hpp"

#include "collision/gjk.hpp"

#include <algorithm>
#include <cmath>

namespace filum::collision {

namespace {

constexpr double kTop = 1e5; // mm above the tip: upper end of the head

// std::hypot would take half of all time; coordinates are far from overflow.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

Vec3 farthest(std::span<const Vec3> points, const Vec3& d) {
    const Vec3* best = points.data();
    for (const Vec3& p : points)
        if (dot(p, d) > dot(*best, d)) best = &p;
    return *best;
}

// A disc about the axis, whose support points are needed.
struct Disc {
    double radius, z;
};
template <std::size_t N>
Vec3 farthest(const std::array<Disc, N>& discs, const Vec3& d) {
    const double across = length(d.x, d.y);
    const Disc* best = discs.data();
    for (const Disc& disc : discs)
        if (disc.radius * across + disc.z * d.z > best->radius * across + best->z * d.z) best = &disc;
    const double r = across > 0 ? best->radius / across : 0;
    return {r * d.x, r * d.y, best->z};
}

} // namespace

Shape::Shape(const machine::Head& head)
    : none_(head.none), flat_(head.flat_radius), wide_(head.cone_radius(head.cone_height)), height_(head.cone_height),
      half_x_(head.carriage_x / 2), half_y_(head.carriage_y / 2), half_diagonal_(std::hypot(half_x_, half_y_)),
      gantry_(head.gantry_height), out_(std::cos(head.cone_angle / 2)), down_(std::sin(head.cone_angle / 2)) {}

// For the nozzle, which is convex: the greatest distance from its flat, its side and its vertical wall as planes.
double Shape::at_least(double r, double z) const {
    const double nozzle = std::max({0.0, -z, (r - flat_) * out_ - z * down_, r - wide_});
    const double column = length(std::max(0.0, r - half_diagonal_), std::max(0.0, height_ - z));
    return std::min({nozzle, column, std::max(0.0, gantry_ - z)});
}

Shape::NearestPiece Shape::nearest(std::span<const Vec3> corners, bool round, double cutoff) const {
    NearestPiece best{cutoff, HeadPiece::nozzle};
    const auto take = [&](double d, HeadPiece piece) {
        if (d < best.distance) best = {d, piece};
    };
    double top = corners[0].z;
    for (const Vec3& p : corners) top = std::max(top, p.z);
    const auto polygon = [&](const Vec3& d) { return farthest(corners, d); };
    const auto start = [&](double low) { return corners[0] - Vec3{0, 0, std::clamp(corners[0].z, low, kTop)}; };

    const std::array<Disc, 3> nozzle{Disc{flat_, 0}, {wide_, height_}, {wide_, kTop}};
    take(gjk_distance(
             polygon, [&](const Vec3& d) { return farthest(nozzle, d); }, start(0), best.distance),
         HeadPiece::nozzle);
    if (best.distance > 0 && height_ - top < best.distance && half_x_ > 0 && half_y_ > 0) {
        const std::array<Disc, 2> column{Disc{half_diagonal_, height_}, {half_diagonal_, kTop}};
        const auto box = [&](const Vec3& d) {
            if (round) return farthest(column, d);
            return Vec3{d.x < 0 ? -half_x_ : half_x_, d.y < 0 ? -half_y_ : half_y_, d.z < 0 ? height_ : kTop};
        };
        take(gjk_distance(polygon, box, start(height_), best.distance), HeadPiece::carriage);
    }
    take(std::max(0.0, gantry_ - top), HeadPiece::gantry);
    return best;
}

} // namespace filum::collision
