// Rings with their corners, as these are being rounded.
#pragma once

#include "geom/point_tree.hpp"
#include "surface/curve/line.hpp"

#include <cmath>
#include <vector>

namespace filum::surfpath::rings {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// A position on one of several rings, and its distance from the point for which it was searched.
struct RingPosition {
    std::size_t line = 0;
    double way = 0, distance = 1e300;
};

// A stretch of a ring around a corner, and the arc that replaces it.
struct Corner {
    double from, to; // arc lengths of its ends; `to` is less than `from` if it contains the ring's start
    Line arc;
    double length = 0; // mm, of `arc`
};

// A ring and, for each of several radii, its corners.
struct Ring {
    Line line;
    std::vector<double> ways;
    struct Contact { // a position where a rounded line, given by its number, coincides with the ring
        double way;
        std::size_t line;
    };
    struct RadiusResult {
        std::vector<Corner> corners{};
        std::vector<Contact> kept{};
        std::vector<Line> instead{};        // closed lines inside that may replace the whole ring
        std::vector<std::size_t> numbers{}; // their numbers
    };
    std::vector<RadiusResult> by{}; // per radius

    [[nodiscard]] double ahead(double from, double to) const {
        const double d = std::fmod(to - from, ways.back());
        return d < 0 ? d + ways.back() : d;
    }
    [[nodiscard]] bool within(const Corner& c, const Corner& outer) const {
        const double slack = 0.01, l = ahead(outer.from - slack, outer.to + slack);
        const double a = ahead(outer.from - slack, c.from), b = ahead(outer.from - slack, c.to);
        return a <= b && b <= l;
    }
};

// The points of several rings in a tree. It refers to the rings, which must not change.
class RingTree {
  public:
    explicit RingTree(std::span<const Ring> rings);

    // The position nearest to `p` in space, in logarithmic time.
    [[nodiscard]] RingPosition nearest(const Vec3& p) const;

  private:
    std::span<const Ring> rings_;
    std::vector<std::size_t> end_; // per ring: index after its last point
    geom::PointTree tree_;
};

} // namespace filum::surfpath::rings
