// Finds nearest places on bead lines, and the segments in a box.
#pragma once

#include "geom/capsule_tree.hpp"
#include "geom/segment_grid.hpp"
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
    double distance = 0; // mm, from the point of the query
};

class SegmentIndex {
  public:
    // Indexes the segments of all curves, numbered in their order. The last segment of a closed curve leads back to its
    // first point.
    explicit SegmentIndex(std::span<const toolpath::Curve> curves);

    [[nodiscard]] bool empty() const { return first_.size() < 2 || first_.back() == 0; }
    [[nodiscard]] Box2 bounds() const { return bounds_; }

    // The place nearest to p that is at most `limit` mm away. Curves with skip[curve] != 0 are left out; an empty
    // `skip` leaves out none. Tie: the lowest segment number.
    [[nodiscard]] std::optional<Place> nearest(Vec2 p, double limit = std::numeric_limits<double>::infinity(),
                                               std::span<const char> skip = {}) const;

    // The place nearest to p. The search first looks at `last` and at the segments beside it on its curve; if p lies on
    // one of these, it takes constant time. Where lines lie on each other, the place may be on another line than that
    // of nearest().
    [[nodiscard]] std::optional<Place> follow(Vec2 p, const std::optional<Place>& last) const;

    // Calls `visit` with the number and the ends of every segment whose bounding box meets `box`, in ascending order.
    // Stops when `visit` returns false.
    void within(const Box2& box, const std::function<bool(std::uint32_t, Vec2, Vec2)>& visit) const;

    // The points with the least x, greatest x, least y and greatest y, in this order. Tie: the lowest segment number.
    [[nodiscard]] std::vector<Place> extremes() const;

    // The place at parameter t of segment number `segment`; its distance is measured from `from`.
    [[nodiscard]] Place place(std::uint32_t segment, double t, Vec2 from) const;

    [[nodiscard]] std::uint32_t curve_of(std::uint32_t segment) const;

  private:
    [[nodiscard]] std::pair<Vec2, Vec2> ends(std::uint32_t segment) const;

    std::vector<Vec2> points_;         // of all curves; the first point of a closed curve is repeated at its end
    std::vector<std::uint32_t> first_; // segment numbers: curve c has [first_[c], first_[c + 1])
    Box2 bounds_;
    geom::CapsuleTree tree_; // of all segments
};

// The segments of curves in a grid, numbered as in SegmentIndex. It answers questions about small neighbourhoods faster
// than a tree, because their cells are found by calculation.
class SegmentCells {
  public:
    explicit SegmentCells(std::span<const toolpath::Curve> curves);

    struct Nearest {
        std::uint32_t segment;
        double distance; // mm
    };
    // The segment nearest to p that is at most `limit` mm away. Tie: the lowest number.
    [[nodiscard]] std::optional<Nearest> nearest(Vec2 p, double limit) const;

    // Whether a -> b stays more than `margin` mm away from every segment.
    [[nodiscard]] bool is_free(Vec2 a, Vec2 b, double margin) const;

  private:
    void search(Vec2 p, double limit, std::optional<Nearest>& found) const;

    std::vector<geom::Segment> segments_;
    double cell_; // mm
    geom::SegmentGrid grid_;
};

// Whether a -> b stays more than `margin` mm away from every segment, without its first `skip_a` mm and its last
// `skip_b` mm. True if nothing of a -> b is left.
bool is_free(const SegmentCells& cells, Vec2 a, Vec2 b, double margin, double skip_a, double skip_b);
bool is_free(const SegmentIndex& index, Vec2 a, Vec2 b, double margin, double skip_a, double skip_b);

} // namespace filum::link3d
