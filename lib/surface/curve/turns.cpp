#include "surface/curve/turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::surface::curve {

using geom::Vec3;

namespace {

constexpr double kLookStep = kTurnReach / 5; // mm between places that are looked at
constexpr double kNever = std::numeric_limits<double>::infinity();

// A place that moves on along a path.
class Runner {
  public:
    Runner(std::span<const Vec3> points, std::span<const Vec3> normals, std::span<const double> ways)
        : points_(points), normals_(normals), ways_(ways) {}

    void go_to(double way) {
        while (at_ + 2 < points_.size() && ways_[at_ + 1] < way) ++at_;
        const double l = ways_[at_ + 1] - ways_[at_];
        part_ = l > 0 ? std::clamp((way - ways_[at_]) / l, 0.0, 1.0) : 0;
    }
    [[nodiscard]] Vec3 point() const { return points_[at_] + part_ * (points_[at_ + 1] - points_[at_]); }
    [[nodiscard]] Vec3 normal() const {
        const Vec3 n = (1 - part_) * normals_[at_] + part_ * normals_[at_ + 1];
        const double l = norm(n);
        return l > 0 ? 1 / l * n : Vec3{};
    }

  private:
    std::span<const Vec3> points_, normals_;
    std::span<const double> ways_;
    std::size_t at_ = 0;
    double part_ = 0;
};

// The radius of the circle through a - b - c, as they lie on the plane across the normal.
double radius_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
    const auto flat = [&](const Vec3& v) { return v - dot(v, normal) * normal; };
    const Vec3 u = flat(b - a), v = flat(c - b);
    if (dot(u, v) < 0) return kTurnReach / 2; // it comes back, if not on itself: then there is no circle
    const double area = norm(cross(u, v)), sides = norm(u) * norm(v) * norm(u + v);
    return area > 0 ? std::max(kTurnReach / 2, sides / (2 * area)) : kNever;
}

// Calls f(way, radius) at all places.
template <class F>
void each_radius(std::span<const Vec3> points, std::span<const Vec3> normals, const F& f) {
    if (points.size() < 3) return;
    std::vector<double> ways{0};
    for (std::size_t i = 1; i < points.size(); ++i) ways.push_back(ways.back() + distance(points[i - 1], points[i]));
    const double room = ways.back() - 2 * kTurnReach;
    if (!(room >= 0)) return;
    const auto n = static_cast<std::size_t>(std::ceil(room / kLookStep));
    Runner before(points, normals, ways);
    Runner here = before, behind = before;
    for (std::size_t i = 0; i <= n; ++i) {
        const double way = kTurnReach + (n > 0 ? room * static_cast<double>(i) / static_cast<double>(n) : 0);
        before.go_to(way - kTurnReach);
        here.go_to(way);
        behind.go_to(way + kTurnReach);
        f(way, radius_through(before.point(), here.point(), behind.point(), here.normal()));
    }
}

} // namespace

std::vector<TightTurn> tight_turns(std::span<const Vec3> points, std::span<const Vec3> normals, double radius) {
    std::vector<TightTurn> out;
    bool within = false;
    each_radius(points, normals, [&](double way, double r) {
        if (!(r < radius)) {
            within = false;
            return;
        }
        if (!within) out.push_back({way - kLookStep / 2, way, r, way});
        out.back().to = way + kLookStep / 2;
        if (r < out.back().radius) out.back().radius = r, out.back().at = way;
        within = true;
    });
    return out;
}

double least_radius(std::span<const Vec3> points, std::span<const Vec3> normals) {
    double out = kNever;
    each_radius(points, normals, [&](double, double r) { out = std::min(out, r); });
    return out;
}

} // namespace filum::surface::curve
