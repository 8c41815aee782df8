// A ring whose corners are being rounded.
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

// A place on one of several rings.
struct On {
    std::size_t line = 0;
    double way = 0, distance = 1e300;
};

// A stretch of a ring about a corner, and what runs there instead.
struct Corner {
    double from, to; // ways; `to` may be less, round the end
    Line arc;
    double length = 0; // mm, of the arc
};

// A ring, and its corners as they are rounded by one radius after the other.
struct Ring {
    Line line;
    std::vector<double> ways;
    struct Touch { // a place where it stays as it is, and the rounded line that it belongs to, by number
        double way;
        std::size_t line;
    };
    struct Rounded {
        std::vector<Corner> corners{};
        std::vector<Touch> kept{};
        std::vector<Line> instead{};        // that it may be left out for: they run all round within it
        std::vector<std::size_t> numbers{}; // of these
    };
    std::vector<Rounded> by{}; // per radius

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

// Rings by the points of their lines; their lines and ways stay as they are.
class RingTree {
  public:
    explicit RingTree(std::span<const Ring> rings);

    // The place nearest to `p`, straight; about the log of all points.
    [[nodiscard]] On nearest(const Vec3& p) const;

  private:
    std::span<const Ring> rings_;
    std::vector<std::size_t> end_; // per ring: of its points among all
    geom::PointTree tree_;
};

} // namespace filum::surfpath::rings
