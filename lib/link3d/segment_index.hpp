// Nearest places on bead lines, and what crosses them: a packed hierarchy of boxes over consecutive segments.
//
// Consecutive segments of a curve lie together, so their boxes are tight without any sorting.  Each box is turned as
// its segments run: boxes of slanting rows would overlap otherwise, and a query would look at all rows.  Building takes
// n log n, a query is logarithmic on fill curves.
#pragma once

#include "geom/vec.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace filum::link3d {

using geom::Box2;
using geom::Vec2;

// A point on a curve: points[segment] + t * (points[segment + 1] - points[segment]).
struct Place {
    std::uint32_t curve = 0, segment = 0;
    double t = 0;        // [0, 1]
    Vec2 point;          //
    double distance = 0; // mm, from where it was asked for
};

class SegmentIndex {
  public:
    // The segments of all curves, numbered in their order; a closed curve's last segment runs back to its first point.
    explicit SegmentIndex(std::span<const toolpath::Curve> curves);

    [[nodiscard]] bool empty() const { return first_.size() < 2 || first_.back() == 0; }
    [[nodiscard]] Box2 bounds() const { return bounds_; }

    // The place nearest to p that is at most `limit` mm away, of the curves for which skip[curve] is false (all, if
    // `skip` is empty).  Tie: the lowest segment number.
    [[nodiscard]] std::optional<Place> nearest(Vec2 p, double limit = std::numeric_limits<double>::infinity(),
                                               std::span<const char> skip = {}) const;

    // The place nearest to p.  First looks at `last` and at the segments beside it on its curve: if p lies on one of
    // these, this takes constant time.  Where lines lie on each other, the place may be on another one than nearest()
    // gives.
    [[nodiscard]] std::optional<Place> follow(Vec2 p, const std::optional<Place>& last) const;

    // Calls `visit` with the number and the ends of every segment that meets `box`, in ascending order, and of some
    // others.  Stops when `visit` returns false.
    void within(const Box2& box, const std::function<bool(std::uint32_t, Vec2, Vec2)>& visit) const;

    // The leftmost, rightmost, front and back places.  Tie: the lowest segment number.
    [[nodiscard]] std::vector<Place> extremes() const;

    // The place at parameter t of segment number `segment`.
    [[nodiscard]] Place place(std::uint32_t segment, double t, Vec2 from) const;

  private:
    // A box with sides along x and left_of(x).
    struct TurnedBox {
        Vec2 x{1, 0}; // unit
        Box2 box;     // as seen with that x axis
        void add(Vec2 p);
        [[nodiscard]] double distance(Vec2 p) const; // at most the true one
        [[nodiscard]] bool may_meet(const Box2& other) const;
    };
    [[nodiscard]] std::vector<TurnedBox> boxes_of(std::uint32_t segments) const;
    [[nodiscard]] std::pair<Vec2, Vec2> ends(std::uint32_t segment) const;
    [[nodiscard]] std::uint32_t curve_of(std::uint32_t segment) const;

    std::vector<Vec2> points_;         // of all curves; a closed curve's first point stands again at its end
    std::vector<std::uint32_t> first_; // segment numbers: curve c has [first_[c], first_[c + 1])
    Box2 bounds_;
    std::vector<std::vector<TurnedBox>> levels_; // levels_[0]: boxes of kFan segments; levels_[k]: of kFan boxes below
};

// The part of a -> b without the first `skip_a` mm and the last `skip_b` mm stays more than `margin` mm away from every
// segment.  True if there is no such part.
bool is_free(const SegmentIndex& index, Vec2 a, Vec2 b, double margin, double skip_a, double skip_b);

} // namespace filum::link3d
