#include "surface/curve/turns.hpp"

#include "geom/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::surface::curve {

using geom::Vec3;

namespace {

constexpr double kLooks = 5; // places per reach at which the radius is measured
constexpr double kNever = std::numeric_limits<double>::infinity();

// A position that moves forwards along a path.
class PathCursor {
  public:
    PathCursor(std::span<const Vec3> points, std::span<const Vec3> normals, std::span<const double> ways)
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

// Radius of the circle through a, b and c in projection along the normal.
double radius_through(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal, double reach) {
    const auto flat = [&](const Vec3& v) { return v - dot(v, normal) * normal; };
    const Vec3 u = flat(b - a), v = flat(c - b);
    if (dot(u, v) < 0) return reach / 2; // the path reverses; the circle does not describe that
    const double area = norm(cross(u, v)), sides = norm(u) * norm(v) * norm(u + v);
    return area > 0 ? std::max(reach / 2, sides / (2 * area)) : kNever;
}

// The arc lengths at which to measure, ascending: at equal steps, and wherever one of the three points passes a point
// of the path, where a corner has most effect.
std::vector<double> places_to_look(std::span<const double> ways, double reach) {
    const double first = reach, last = ways.back() - reach;
    const auto n = static_cast<std::size_t>(std::ceil(kLooks * (last - first) / reach));
    std::vector<double> out;
    for (std::size_t i = 0; i < n; ++i)
        out.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(n));
    out.push_back(last);
    for (const double way : ways)
        for (const double off : {-reach, 0.0, reach})
            if (way + off > first && way + off < last) out.push_back(way + off);
    std::sort(out.begin(), out.end());
    return out;
}

struct RadiusSample {
    double way, radius;
};

std::vector<RadiusSample> looks(std::span<const Vec3> points, std::span<const Vec3> normals, double reach) {
    if (points.size() < 3) return {};
    const std::vector<double> ways = geom::arc_lengths(points);
    if (!(ways.back() >= 2 * reach)) return {};
    std::vector<RadiusSample> out;
    PathCursor before(points, normals, ways);
    PathCursor here = before, behind = before;
    for (const double way : places_to_look(ways, reach)) {
        before.go_to(way - reach);
        here.go_to(way);
        behind.go_to(way + reach);
        out.push_back({way, radius_through(before.point(), here.point(), behind.point(), here.normal(), reach)});
    }
    return out;
}

} // namespace

double turn_reach(double radius, double spacing) {
    return std::max(spacing / 4, 2 * std::sqrt(kRipple * spacing * std::max(0.0, radius)));
}

double length(std::span<const TightTurn> turns) {
    double out = 0;
    for (const TightTurn& t : turns) out += t.to - t.from;
    return out;
}

std::vector<TightTurn> tight_turns(std::span<const Vec3> points, std::span<const Vec3> normals, double radius,
                                   double reach) {
    std::vector<TightTurn> out;
    const auto all = looks(points, normals, reach);
    const double half_step = reach / kLooks / 2;   // mm, for which the first and the last sample stand
    for (std::size_t i = 0; i < all.size(); ++i) { // each sample stands for half of the way to its neighbours
        const auto& [way, r] = all[i];
        if (!(r < radius)) continue;
        if (i == 0 || !(all[i - 1].radius < radius))
            out.push_back({i > 0 ? (all[i - 1].way + way) / 2 : way - half_step, way, r, way});
        out.back().to = i + 1 < all.size() ? (way + all[i + 1].way) / 2 : way + half_step;
        if (r < out.back().radius) {
            out.back().radius = r;
            out.back().at = way;
        }
    }
    return out;
}

double least_radius(std::span<const Vec3> points, std::span<const Vec3> normals, double reach) {
    double out = kNever;
    for (const RadiusSample& l : looks(points, normals, reach)) out = std::min(out, l.radius);
    return out;
}

} // namespace filum::surface::curve
