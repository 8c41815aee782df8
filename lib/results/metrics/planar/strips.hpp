// Beads that pass a box from side to side: strips, whose areas have a closed form. Private to
// lib/results/metrics/planar.
#pragma once

#include "metrics/planar/row_sections.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace filum::metrics::planar {

using geom::Box2;

// A convex polygon of a few corners.
class Convex {
  public:
    void add(Vec2 p) { corner_.at(size_++) = p; }
    [[nodiscard]] double area() const {
        double twice = 0;
        for (std::size_t i = 2; i < size_; ++i) twice += geom::orient(corner_[0], corner_[i - 1], corner_[i]);
        return std::abs(twice) / 2;
    }
    [[nodiscard]] Convex within(const Box2& box) const {
        return cut({1, 0}, box.lo.x).cut({-1, 0}, -box.hi.x).cut({0, 1}, box.lo.y).cut({0, -1}, -box.hi.y);
    }
    // The part to the left of the line from a to b.
    [[nodiscard]] Convex left_of(Vec2 a, Vec2 b) const {
        const Vec2 normal = geom::left_of(b - a);
        return cut(normal, geom::dot(a, normal));
    }

  private:
    // The part where dot(p, normal) >= least.
    [[nodiscard]] Convex cut(Vec2 normal, double least) const {
        Convex out;
        for (std::size_t i = 0; i < size_; ++i) {
            const Vec2 p = corner_[i], q = corner_[i + 1 == size_ ? 0 : i + 1];
            const double a = geom::dot(p, normal) - least, b = geom::dot(q, normal) - least;
            if (a >= 0) out.add(p);
            if ((a >= 0) != (b >= 0)) out.add(geom::lerp(p, q, a / (a - b)));
        }
        return out;
    }

    std::array<Vec2, 12> corner_{}; // four, and one more for each cut
    std::size_t size_ = 0;
};

// A bead that passes a tile, in the frame of the first one: along it from `near` to `far`, across it from lo to hi.
struct Strip {
    std::array<double, 2> lo{}, hi{}; // at near and far
};

// Beads that pass a tile one beside the other.
struct Strips {
    Vec2 along;
    double near = 0, far = 0;
    std::vector<Strip> strip; // by position

    [[nodiscard]] Vec2 point(double t, double s) const { return t * along + s * geom::left_of(along); }
};

// The beads that pass a box, as strips in the order of their positions; nothing if one ends in the box, or if the order
// is not the same at both ends. Precondition: `of` holds numbers of beads, at least one.
std::optional<Strips> strips(std::span<const SweptBead> beads, const std::vector<std::uint32_t>& of, const Box2& box);

// Whether no strip reaches the next but one.
bool side_by_side(const std::vector<Strip>& strip);

// Strips that overlap at both ends become one. Returns whether none overlap at one end only.
bool merge(std::vector<Strip>& strip);

// The part of a box between two lines, where the upper one is above the lower one.
Convex between(const Strips& all, const std::array<double, 2>& lower, const std::array<double, 2>& upper,
               const Box2& box);

// Calls f(part, sign) for parts of the box whose areas, by their signs, sum up to the area under the strips.
template <class F>
void each_part(const Strips& all, const Box2& box, F&& f) {
    for (std::size_t i = 0; i < all.strip.size(); ++i) {
        f(between(all, all.strip[i].lo, all.strip[i].hi, box), 1);
        if (i + 1 < all.strip.size()) f(between(all, all.strip[i + 1].lo, all.strip[i].hi, box), -1);
    }
}

} // namespace filum::metrics::planar
