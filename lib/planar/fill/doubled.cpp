#include "fill/doubled.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace filum::fill {

namespace {

constexpr double kSteps = 16; // of the measure, per width of the bead

// How far points at distance `s` along the half circle of diameter `w` on both sides of its middle are apart.
double on_half_circle(double s, double w) { return w * std::sin(std::min(2 * s / w, std::numbers::pi / 2)); }

constexpr double kRight = std::numbers::sqrt2 / 4; // chord of a right angle with sides of a quarter, in widths

struct Turn {
    double at = 0; // mm along the curve
    // mm by which the points a quarter of the width before and after it are nearer to each other than at a right angle
    double nearer = 0;
    double width = 0;
};

class Measure {
  public:
    explicit Measure(const toolpath::Curve& c) : c_(c) {
        const std::size_t n = c.points.size();
        along_.reserve(n + 1);
        along_.push_back(0);
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < n; ++i)
            along_.push_back(along_.back() + geom::distance(c.points[i], c.points[i + 1 < n ? i + 1 : 0]));
    }

    void add_to(Doubled& sum, double& most) const {
        const std::vector<Turn> turns = find_turns();
        for (std::size_t k = 0; k < turns.size(); ++k) {
            const double area = doubled(turns[k], reach(turns, k));
            sum.area += area;
            if (area <= most) continue;
            most = area;
            sum.at = place(turns[k].at).p;
        }
    }

  private:
    [[nodiscard]] double total() const { return along_.back(); }

    struct Place {
        geom::Vec2 p;
        double width = 0;
    };
    [[nodiscard]] Place place(double s) const {
        if (c_.closed && total() > 0) s -= total() * std::floor(s / total());
        s = std::clamp(s, 0.0, total());
        const auto above = std::upper_bound(along_.begin() + 1, along_.end() - 1, s);
        const auto i = static_cast<std::size_t>(above - along_.begin()) - 1, j = (i + 1) % c_.points.size();
        return {on(i, s), c_.width_at(i) + share(i, s) * (c_.width_at(j) - c_.width_at(i))};
    }
    [[nodiscard]] double share(std::size_t segment, double s) const {
        const double length = along_[segment + 1] - along_[segment];
        return length > 0 ? (s - along_[segment]) / length : 0;
    }
    [[nodiscard]] geom::Vec2 on(std::size_t segment, double s) const {
        const std::size_t j = segment + 1 < c_.points.size() ? segment + 1 : 0;
        return geom::lerp(c_.points[segment], c_.points[j], share(segment, s));
    }

    // The apexes of turns sharper than a right angle, in their order. Of vertices less than half a width from the one
    // before, the apex is the one whose sides are nearest.
    [[nodiscard]] std::vector<Turn> find_turns() const {
        std::vector<Turn> out;
        double last = 0;
        std::size_t before = 0, behind = 0; // the nearest vertices that are a quarter of the width away, or an end
        const std::size_t ends = c_.closed ? 0 : 1;
        for (std::size_t i = ends; i + ends < c_.points.size(); ++i) {
            const double w = c_.width_at(i), s = along_[i];
            while (before < i && along_[before + 1] <= s - w / 4) ++before;
            while (behind + 1 < c_.points.size() && along_[behind] < s + w / 4) ++behind;
            const double most = kRight * w + (along_[behind] - along_[before] - w / 2);
            const bool inside = along_[before] <= s - w / 4 && along_[behind] >= s + w / 4;
            if (inside && geom::norm2(c_.points[behind] - c_.points[before]) >= most * most) continue;
            const double nearer = kRight * w - geom::distance(place(s - w / 4).p, place(s + w / 4).p);
            if (!(nearer > 0)) continue;
            if (out.empty() || s - last > w / 2)
                out.push_back({s, nearer, w});
            else if (nearer > out.back().nearer)
                out.back() = {s, nearer, w};
            last = s;
        }
        return out;
    }

    // The way to the nearer one of the next turns, and at most to the end of the curve.
    [[nodiscard]] double reach(const std::vector<Turn>& turns, std::size_t k) const {
        const double s = turns[k].at, end = c_.closed ? total() / 2 : std::min(s, total() - s);
        const double before = k > 0 ? s - turns[k - 1].at : c_.closed ? s + total() - turns.back().at : end;
        const double behind = k + 1 < turns.size() ? turns[k + 1].at - s
                              : c_.closed          ? turns.front().at + total() - s
                                                   : end;
        double out = end;
        for (const double leg : {before, behind})
            if (leg > 0) out = std::min(out, leg);
        return out;
    }

    [[nodiscard]] double doubled(const Turn& t, double reach) const {
        const double step = t.width / kSteps;
        double out = 0;
        for (double s = step / 2; s < reach; s += step) {
            const Place a = place(t.at - s), b = place(t.at + s);
            const double w = (a.width + b.width) / 2, apart = geom::distance(a.p, b.p);
            if (w > 0) out += std::max(0.0, on_half_circle(s, w) - apart) * step;
            if (apart >= t.width) break; // the legs have parted
        }
        return out;
    }

    const toolpath::Curve& c_;
    std::vector<double> along_; // per vertex, and the end of a closed curve
};

} // namespace

Doubled doubled_at_turns(std::span<const toolpath::Curve> curves) {
    Doubled out;
    double most = 0;
    for (const toolpath::Curve& c : curves)
        if (c.points.size() > 2) Measure(c).add_to(out, most);
    return out;
}

} // namespace filum::fill
