#include "polygon/moved_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace filum::polygon {

namespace {

constexpr double kCoarsest = 0.25; // of the distance: the largest deviation of an arc

// Moves one loop.
class Mover {
  public:
    Mover(double delta, double tolerance)
        : delta_(delta), tolerance_(std::min(tolerance, kCoarsest * std::abs(delta))),
          step_(2 * std::acos(1 - tolerance_ / std::abs(delta))) {}

    void add(std::span<const Vec2> loop, Loops& to) {
        corner_.clear();
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (loop[i] != loop[i + 1 == loop.size() ? 0 : i + 1]) corner_.push_back(loop[i]);
        const std::size_t n = corner_.size();
        if (n < 3) return;
        along_.resize(n);
        length_.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 way = corner_[i + 1 == n ? 0 : i + 1] - corner_[i];
            length_[i] = geom::norm(way);
            along_[i] = (1 / length_[i]) * way;
        }
        for (std::size_t i = 0; i < n; ++i) pass(i, i == 0 ? n - 1 : i - 1, to);
        to.close();
    }

  private:
    // Adds what becomes of corner i, between the edges `before` and i.
    void pass(std::size_t i, std::size_t before, Loops& to) const {
        const Vec2 p = corner_[i], u = along_[before], v = along_[i];
        const Vec2 m = -1.0 * geom::left_of(u), n = -1.0 * geom::left_of(v);
        const double sine = geom::cross(u, v), cosine = geom::dot(u, v);
        const bool back = cosine < 0 && sine == 0, parts = back || sine * delta_ > 0;
        const double half = std::sqrt(std::max(0.0, (1 + cosine) / 2)); // cosine of half the turn
        if (!parts && std::abs(delta_) * std::sqrt(1 - half * half) <= half * std::min(length_[before], length_[i]) / 2)
            return to.points.push_back(p + (delta_ / (1 + cosine)) * (m + n)); // the moved edges meet there
        if (!parts) { // one of them is too short to meet the other: the way between them winds the other way
            to.points.push_back(p + delta_ * m);
            to.points.push_back(p);
            to.points.push_back(p + delta_ * n);
            return;
        }
        if (std::abs(delta_) * (1 - half) <= tolerance_ * half)
            return to.points.push_back(p + (delta_ / (1 + cosine)) * (m + n));
        const double turn = std::copysign(std::acos(std::clamp(cosine, -1.0, 1.0)), delta_);
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step_)));
        const Vec2 aside = geom::left_of(m);
        for (int k = 0; k < steps; ++k) {
            const double t = turn * k / steps;
            to.points.push_back(p + (delta_ * std::cos(t)) * m + (delta_ * std::sin(t)) * aside);
        }
        to.points.push_back(p + delta_ * n);
    }

    double delta_, tolerance_, step_; // mm, mm, rad
    std::vector<Vec2> corner_, along_;
    std::vector<double> length_;
};

} // namespace

Loops moved_outlines(const Loops& a, double delta, double tolerance) {
    if (delta == 0) return a;
    Loops out;
    Mover mover(delta, tolerance);
    for (std::size_t l = 0; l < a.size(); ++l) mover.add(a[l], out);
    return out;
}

} // namespace filum::polygon
