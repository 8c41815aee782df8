// The fronts of a distance field, one behind the other, and where straight lines lead from each to the next.
#pragma once

#include "geodesic/exact.hpp"
#include "surfpath/strands/source_lines.hpp"

#include <optional>

namespace filum::surfpath::strands {

// A line of equal distance; the way it came lies to its left.  Of a source curve there are two, one for each side.
struct Front {
    Line line;
    std::vector<double> ways; // of its points, mm

    [[nodiscard]] double length() const { return ways.back(); }
};

// A place on a front of some level.
struct Spot {
    std::uint32_t front = 0;
    double x = 0; // mm along it
};

class Fronts {
  public:
    // Level 0 are the source curves, each way round; level k lies k * step mm from all sources.  `grain` is how far
    // apart straight lines are that tell where all others lead.
    // Throws Error(usage) if there were more than 20,000 levels.
    Fronts(const Surface& surface, const surface::Sources& sources, double step, double grain);

    [[nodiscard]] std::size_t levels() const { return levels_.size(); }
    [[nodiscard]] const std::vector<Front>& at(std::size_t level) const { return levels_[level].fronts; }
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] const Surface& surface() const { return surface_; }

    [[nodiscard]] Place place(std::size_t level, Spot spot) const;

    // Where on the next level the line leads that stands upright on the front here: on a shortest path from the
    // sources (Mitchell, Mount, Papadimitriou 1987), so that lines never cross.  None where it ends at a rim or passes
    // where another way is shorter.
    [[nodiscard]] std::optional<Spot> onward(std::size_t level, Spot spot) const;

    // The line from the spot on to its end: a rim, or where another way from the sources is shorter.  At most two steps
    // long.
    [[nodiscard]] Line last(std::size_t level, Spot spot) const;

  private:
    struct Piece { // of a front
        std::uint32_t triangle, front, stretch;
    };
    struct Sample {
        double x;
        std::optional<Spot> to;
    };
    struct Level {
        std::vector<Front> fronts;
        std::vector<Piece> pieces;               // by triangles
        std::vector<std::vector<Sample>> onward; // per front, ascending
    };
    void add_level(std::vector<Line> lines);
    void sample(std::size_t level, double grain);
    [[nodiscard]] Vec3 heading(std::size_t level, Spot spot, const Place& from) const;
    [[nodiscard]] std::optional<Spot> walk_on(std::size_t level, Spot spot) const;
    [[nodiscard]] std::optional<Spot> locate(std::size_t level, const Place& p) const;

    const Surface& surface_;
    geodesic::ExactField field_;
    double step_;
    std::vector<Level> levels_;
};

} // namespace filum::surfpath::strands
