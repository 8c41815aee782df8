#include "metrics/surface/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::surface {

namespace {

constexpr double kTurn = std::numbers::pi / 2; // rad: the least angle of a turn,
constexpr double kStepsEachWay = 8;            // steps before and after: within which the angle is reached
constexpr double kApart = 1e-3;                // steps
constexpr double kPlaces = 4;                  // per step

// rad, positive to the left, seen against the normal.
double turning(const Vec3& before, const Vec3& after, const Vec3& n) {
    const Vec3 a = before - dot(before, n) * n, b = after - dot(after, n) * n;
    return std::atan2(dot(cross(a, b), n), dot(a, b));
}

// The chain's points except those within `least` mm along it of an earlier one, or of its end, because the direction
// between almost coincident points is arbitrary.
std::vector<std::size_t> apart(const Fibre& c, double least) {
    std::vector<std::size_t> out{0};
    for (std::size_t i = 1; i + 1 < c.points.size(); ++i)
        if (c.along[i] - c.along[out.back()] >= least && c.length() - c.along[i] >= least) out.push_back(i);
    out.push_back(c.points.size() - 1);
    return out;
}

// The integral of turning along the chain: linear between knots.
class Sums {
  public:
    Sums(const Fibre& c, std::span<const Vec3> normals, double step) {
        add(0, 0);
        const auto kept = apart(c, kApart * step);
        for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
            const std::size_t h = kept[k - 1], i = kept[k], j = kept[k + 1];
            const double a = c.along[i] - c.along[h], b = c.along[j] - c.along[i];
            add(c.along[i] - std::min(a / 2, step), 0);
            add(c.along[i] + std::min(b / 2, step),
                turning(c.points[i] - c.points[h], c.points[j] - c.points[i], normals[i]));
        }
        add(c.length(), 0);
        const auto outer = [&](double stretch) { return stretch <= 2 * step && kept.size() > 2 ? stretch / 2 : 0; };
        first_ = outer(c.along[kept[1]]);
        last_ = c.length() - outer(c.length() - c.along[kept[kept.size() - 2]]);
    }
    // Outside of these there are only outer halves of short segments, where no point turns.
    [[nodiscard]] double first() const { return first_; }
    [[nodiscard]] double last() const { return last_; }
    [[nodiscard]] double at(double s) const {
        const auto it = std::upper_bound(at_.begin(), at_.end(), s);
        if (it == at_.end()) return sum_.back();
        if (it == at_.begin()) return sum_.front();
        const auto k = static_cast<std::size_t>(it - at_.begin());
        return std::lerp(sum_[k - 1], sum_[k], (s - at_[k - 1]) / (at_[k] - at_[k - 1]));
    }

  private:
    void add(double s, double angle) {
        const double before = sum_.empty() ? 0 : sum_.back();
        at_.push_back(at_.empty() ? s : std::max(s, at_.back()));
        sum_.push_back(before + angle);
    }
    std::vector<double> at_, sum_;
    double first_ = 0, last_ = 0;
};

// The rotation of the normal about the axis across the path, rad per mm of path.
double nod(const Vec3& n0, const Vec3& n1, const Vec3& tangent, double way) {
    const Vec3 change = n1 - n0;
    const double chord = norm(change);
    return chord > 0 ? -dot(change, tangent) / chord * 2 * std::asin(std::min(1.0, chord / 2)) / way : 0;
}

} // namespace

double paper_angle(const Fibres& fibres, double step) {
    std::vector<double> all;
    for (const Fibre& c : fibres.all) {
        const auto p = resampled(c, step);
        all.insert(all.end(), 2, 0.0);
        for (std::size_t i = 1; i + 1 < p.size(); ++i) all.push_back(angle(p[i] - p[i - 1], p[i + 1] - p[i]));
    }
    if (all.empty()) return 0;
    const std::size_t n = (all.size() + 99) / 100;
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n - 1), all.end(), std::greater<>());
    std::sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n)); // fixes the order of summation
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += all[i];
    return sum / static_cast<double>(n);
}

Bends bends(const Fibre& c, std::span<const Vec3> normals, double step) {
    const Sums sums(c, normals, step);
    const auto n = static_cast<std::size_t>(std::max(1.0, std::round(kPlaces * c.length() / step)));
    const double first = sums.first(), last = sums.last();
    Bends out;
    int turned = 0; // -1 or 1 within a turn
    std::size_t stretch = 0, behind = 0, ahead = 0;
    const auto normal_at = [&](double s, std::size_t& from) {
        point_at(c, s, from);
        const double t = std::clamp((s - c.along[from]) / (c.along[from + 1] - c.along[from]), 0.0, 1.0);
        const Vec3 v = (1 - t) * normals[from] + t * normals[from + 1];
        return geom::unit(v, normals[from]);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double s = c.length() * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
        point_at(c, s, stretch);
        const double centre = std::max(first + step, std::min(s, last - step));
        const double lo = centre - step, hi = std::min(last, centre + step);
        const double way = std::max(hi - lo, step); // beyond a chain shorter than a step, the curvature is taken as 0
        const Vec3 here = c.points[stretch + 1] - c.points[stretch];
        const double left = (sums.at(hi) - sums.at(lo)) / way;
        const double down = nod(normal_at(lo, behind), normal_at(hi, ahead), 1 / norm(here) * here, way);
        out.places.push_back({c.length() / static_cast<double>(n), left, down});
        const double wide = sums.at(s + kStepsEachWay * step) - sums.at(s - kStepsEachWay * step);
        const int now = wide > kTurn ? 1 : wide < -kTurn ? -1 : 0;
        if (now != 0 && now != turned) ++out.turns;
        turned = now;
        if (now == 0) continue;
        const Bends::Range near{s - kStepsEachWay * step, s + kStepsEachWay * step};
        if (out.around.empty() || near.from > out.around.back().to)
            out.around.push_back(near);
        else
            out.around.back().to = near.to;
    }
    return out;
}

} // namespace filum::metrics::surface
