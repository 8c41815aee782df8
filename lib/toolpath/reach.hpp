// How far along a line one move reaches.
#pragma once

#include "toolpath/merge.hpp"

#include <limits>

namespace filum::toolpath {

// A span as merging sees it: points no nearer to each other than kLeastMove, and what was laid on the way to each.
struct Line {
    std::vector<Vec3> points;
    std::vector<double> at, volume;    // mm, mm3, from the first point
    std::vector<double> width, height; // mm
    std::vector<double> area;          // mm2
    std::vector<std::uint32_t> source; // segment of the span that begins there

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
    [[nodiscard]] double step(std::uint32_t i) const { return at[i + 1] - at[i]; }
};

// As of merge.hpp, of a move from point `from`.
double full_share(const Line& line, std::uint32_t from, double length);

// Which mean sections suit all that one move would lay.
class Section {
  public:
    Section(const Line& line, std::uint32_t from, double share);
    void take(std::uint32_t k);     // the piece that ends at point k
    [[nodiscard]] bool any() const; // of the sections taken so far some mean may suit all
    [[nodiscard]] bool suits() const;

  private:
    void piece(double a, double b, double width, double length);
    const Line* line_;
    std::uint32_t from_;
    double share_;
    double low_ = 0, high_ = std::numeric_limits<double>::infinity();         // of the mean, mm2: at each point
    double sum_low_ = 0, sum_high_ = std::numeric_limits<double>::infinity(); // of what is laid so far
    double volume_ = 0, length_ = 0;
};

// The farthest point that a straight move in the plane of the level piece [from, last] reaches from point `from`; never
// `from`.  `off` becomes the distance of move and line.
std::uint32_t straight_reach(const Line& line, std::uint32_t from, std::uint32_t last, const Tolerance& t, double& off);

// An arc from one point to another.
struct Arc {
    std::uint32_t to = 0; // no arc: from
    Vec2 centre;
    double sweep = 0; // rad
};

// The farthest point that an arc reaches from `from`, beyond `least` if any.
Arc arc_reach(const Line& line, std::uint32_t from, std::uint32_t least, std::uint32_t last, const Tolerance& t,
              double& off);

// Moves that cross each other or one of `others`, with ends rounded to whole multiples of `grid` mm (0: as they are),
// where what they lay did not, as segments [first, last] of `line`; `begins` of each move, ascending: the point of the
// line where it begins.
struct Tangle {
    std::uint32_t first = 0, last = 0;
};
std::vector<Tangle> tangles(const Line& line, std::span<const Move> moves, std::span<const std::uint32_t> begins,
                            std::span<const geom::Segment> others, double grid);

} // namespace filum::toolpath
