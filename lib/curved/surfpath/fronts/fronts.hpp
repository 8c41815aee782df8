// The fronts of a distance field, which are isolines at equal steps, and where straight lines lead from each to the
// next.
#pragma once

#include "geodesic/exact.hpp"
#include "surfpath/fronts/source_lines.hpp"

#include <optional>

namespace filum::surfpath::fronts {

// An isoline with smaller distances on its left. A source curve is two fronts, one per side.
struct Front {
    Line line;
    std::vector<double> ways; // arc lengths of its points, mm

    [[nodiscard]] double length() const { return ways.back(); }
};

// A place on a front of a known level.
struct Spot {
    std::uint32_t front = 0;
    double x = 0; // mm along the front
};

class Fronts {
  public:
    // Level 0 consists of the source curves, each in both directions; level k is at distance k * step() mm from all
    // sources. Steps are half a spacing, as far as a line may be from where it should be. The lines that are computed
    // exactly are a step apart, too; others are interpolated.
    // Throws Error(usage) if there would be more than 20,000 levels.
    Fronts(const Surface& surface, const surface::Sources& sources, double spacing);

    [[nodiscard]] std::size_t levels() const { return levels_.size(); }
    [[nodiscard]] const std::vector<Front>& at(std::size_t level) const { return levels_[level].fronts; }
    [[nodiscard]] double step() const { return step_; }
    [[nodiscard]] const Surface& surface() const { return surface_; }

    [[nodiscard]] Place place(std::size_t level, Spot spot) const;

    // Where the line perpendicular to the front reaches the next level. It is on a shortest path from the sources
    // (Mitchell, Mount, Papadimitriou 1987), so lines never cross. None if it ends at a rim or where another path is
    // shorter.
    [[nodiscard]] std::optional<Spot> onward(std::size_t level, Spot spot) const;

    // The line from the spot to its end, which is a rim or where another path from the sources is shorter; at most two
    // steps.
    [[nodiscard]] Line last(std::size_t level, Spot spot) const;

  private:
    struct FrontSegment {
        std::uint32_t triangle, front, segment;
    };
    struct Sample {
        double x;
        std::optional<Spot> to;
    };
    struct Level {
        std::vector<Front> fronts;
        std::vector<FrontSegment> segments;      // by triangles
        std::vector<std::vector<Sample>> onward; // per front, ascending
    };
    void add_level(std::vector<Line> lines);
    void sample(std::size_t level);
    [[nodiscard]] Vec3 heading(std::size_t level, Spot spot, const Place& from) const;
    [[nodiscard]] std::optional<Spot> walk_on(std::size_t level, Spot spot) const;
    [[nodiscard]] std::optional<Spot> locate(std::size_t level, const Place& p) const;

    const Surface& surface_;
    geodesic::ExactField field_;
    double step_;
    std::vector<Level> levels_;
};

} // namespace filum::surfpath::fronts
