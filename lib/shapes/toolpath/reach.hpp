// The farthest point that one move can reach along a line.
#pragma once

#include "toolpath/merge.hpp"

#include <limits>

namespace filum::toolpath {

// A span prepared for merging: points at least kLeastMove apart, and the volume up to each.
struct Line {
    std::vector<Vec3> points;
    std::vector<double> at, volume;    // mm, mm3, from the first point
    std::vector<double> width, height; // mm
    std::vector<double> area;          // mm2
    std::vector<std::uint32_t> source; // segment of the span that begins at the point

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
    [[nodiscard]] double step(std::uint32_t i) const { return at[i + 1] - at[i]; }
};

// full_share() of merge.hpp for a move from point `from`.
double full_share(const Line& line, std::uint32_t from, double length);

// The range of mean sections that are acceptable for all segments that one move would replace.
class Section {
  public:
    Section(const Line& line, std::uint32_t from, double share);
    void take(std::uint32_t k);     // adds the segment that ends at point k
    [[nodiscard]] bool any() const; // whether some mean may be acceptable for all sections so far
    [[nodiscard]] bool suits() const;

  private:
    void piece(double a, double b, double width, double length);
    const Line* line_;
    std::uint32_t from_;
    double share_;
    // bounds of the mean, mm2: from the section at each point
    double low_ = 0, high_ = std::numeric_limits<double>::infinity();
    double sum_low_ = 0, sum_high_ = std::numeric_limits<double>::infinity(); // bounds from the volume so far
    double volume_ = 0, length_ = 0;
};

// The farthest point that a straight move from point `from` reaches in the horizontal part [from, last]; greater than
// `from`. Sets `off` to the distance between move and line.
std::uint32_t straight_reach(const Line& line, std::uint32_t from, std::uint32_t last, const Tolerance& t, double& off);

// An arc from one point to another.
struct Arc {
    std::uint32_t to = 0; // `from`: there is no arc
    Vec2 centre;
    double sweep = 0; // rad
};

// The farthest point that an arc from `from` reaches; beyond `least`, or none.
Arc arc_reach(const Line& line, std::uint32_t from, std::uint32_t least, std::uint32_t last, const Tolerance& t,
              double& off);

// Moves that cross each other or one of `others` after their ends were rounded to whole multiples of `grid` mm (0: no
// rounding), although the line did not cross there, as segments [first, last] of `line`. Moves that are segments of the
// line are not compared with each other. `begins`: for each move the point of the line where it begins, ascending.
struct Tangle {
    std::uint32_t first = 0, last = 0;
};
std::vector<Tangle> tangles(const Line& line, std::span<const Move> moves, std::span<const std::uint32_t> begins,
                            std::span<const geom::Segment> others, double grid);

} // namespace filum::toolpath
