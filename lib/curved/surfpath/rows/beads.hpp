// Lines as sequences of bead points, with a search for those near a place. Parts of lines can be removed and lines
// added.
#pragma once

#include "surfpath/lanes/lanes.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// A point of a line.
struct BeadPoint {
    std::uint32_t line = 0;
    double arc = 0; // mm from the line's start
    Vec3 point, normal;
};

// The bead points around a place, in the coordinates of a chart.
struct Surroundings {
    surface::curve::Chart chart;
    struct LinePoint {
        std::uint32_t line;
        double arc;
        Vec2 p;
    };
    std::vector<LinePoint> beads; // of the lines, by line and arc length
    std::vector<Vec2> added;      // of added lines
};

class BeadMap {
  public:
    // `lines` are those of `lanes`, open or closed. Bead points are rules::kFineGrain spacings from each other.
    BeadMap(const Surface& s, const std::vector<Line>& lines, const lanes::Lanes& lanes);

    [[nodiscard]] double length(std::uint32_t line) const { return length_[line]; } // mm
    // Distance of two arc lengths of a line, mm; around the shorter way if it is closed.
    [[nodiscard]] double off(std::uint32_t line, double a, double b) const;
    // Whether nothing is cut within `half` + `margin` mm of `at`.
    [[nodiscard]] bool whole(std::uint32_t line, double at, double half, double margin) const;

    // Removes the part of the line within `half` mm of `at`.
    void cut(std::uint32_t line, double at, double half);
    // Adds another line.
    void add(const Line& line);

    // The bead points within `reach` mm of the chart's origin on surface that faces the same way.
    [[nodiscard]] Surroundings around(const surface::curve::Chart& chart, double reach) const;

    // The nearest point of every line except `but` that is within `reach` mm of `p`, on surface that faces as
    // `normal`, whether it was cut or not. In the order of lines.
    [[nodiscard]] std::vector<BeadPoint> neighbours(std::uint32_t but, const Vec3& p, const Vec3& normal,
                                                    double reach) const;

  private:
    struct CutStretch {
        double at, half;
    };
    struct AddedLine {
        std::vector<BeadPoint> beads;
        geom::Box3 box;
    };
    const Surface& s_;
    double apart_;
    std::vector<double> length_; // per line
    std::vector<char> closed_;
    std::vector<std::vector<CutStretch>> cuts_;
    std::vector<std::uint32_t> first_; // per line, and one more: index of its first bead point
    std::vector<BeadPoint> beads_;
    std::vector<char> cut_beads_; // per bead point: whether its line was cut there
    double cell_;                 // mm, of the grid
    geom::PointGrid<Vec3> grid_;
    std::vector<AddedLine> added_;
};

} // namespace filum::surfpath::rows
