// Lines as beads, point by point: what lies near a place, but for where lines were cut.
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
struct Bead {
    std::uint32_t line = 0;
    double way = 0; // mm
    Vec3 point, normal;
};

// What lies about a place, on a chart.
struct View {
    surface::curve::Chart chart;
    struct At {
        std::uint32_t line;
        double way;
        Vec2 p;
    };
    std::vector<At> beads;  // of lines, by line and way
    std::vector<Vec2> laid; // of what was laid besides
};

class Beads {
  public:
    // Of `lines`, which are those of `lanes`, open or closed; points are `apart` mm from each other.
    Beads(const Surface& s, const std::vector<Line>& lines, const lanes::Lanes& lanes, double apart);

    [[nodiscard]] double length(std::uint32_t line) const { return length_[line]; } // mm
    // How far apart two ways of a line are, mm; of a closed one the shorter way round.
    [[nodiscard]] double off(std::uint32_t line, double a, double b) const;
    // Whether the line is there from `half` mm before `at` to as much behind it, and `margin` mm more on both sides.
    [[nodiscard]] bool whole(std::uint32_t line, double at, double half, double margin) const;

    void cut(std::uint32_t line, double at, double half); // that is no longer there
    void lay(const Line& line);                           // something besides

    // What lies within `reach` mm of the chart's origin and faces as it does.
    [[nodiscard]] View look(const surface::curve::Chart& chart, double reach) const;

    // Per line but this one its point nearest to `p`, where it faces as `normal` does and is no farther than `reach`;
    // cut or not.  By line.
    [[nodiscard]] std::vector<Bead> beside(std::uint32_t but, const Vec3& p, const Vec3& normal, double reach) const;

  private:
    struct Cut {
        double at, half;
    };
    struct Laid {
        std::vector<Bead> beads;
        geom::Box3 about;
    };
    const Surface& s_;
    double apart_;
    std::vector<double> length_; // per line
    std::vector<char> closed_;
    std::vector<std::vector<Cut>> cuts_;
    std::vector<std::uint32_t> first_; // per line, and one more: its beads
    std::vector<Bead> beads_;
    std::vector<char> gone_; // per bead: where its line was cut
    double cell_;            // mm, of the grid
    geom::PointGrid<Vec3> grid_;
    std::vector<Laid> laid_;
};

} // namespace filum::surfpath::rows
