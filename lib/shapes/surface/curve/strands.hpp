// Lines on a surface as points at equal distances that can be moved.
#pragma once

#include "surface/curve/line.hpp"

#include <cstddef>

namespace filum::surface::curve {

// The points of one line within those of all lines.
struct Strand {
    std::size_t first = 0, count = 0; // no points if the line is too short
    bool closed = false;
    Line threaded; // the line
    std::vector<double> arcs;

    // The point `off` after point `i`, both counted within the strand; -1 beyond an end.
    [[nodiscard]] std::ptrdiff_t at(std::size_t i, std::ptrdiff_t off) const {
        const auto n = static_cast<std::ptrdiff_t>(count);
        const std::ptrdiff_t j = static_cast<std::ptrdiff_t>(i) + off;
        if (closed) return ((j % n) + n) % n;
        return j >= 0 && j < n ? j : -1;
    }
};

// The points [from, to) of a strand; on a closed one they may pass its first point.
struct StrandRun {
    std::ptrdiff_t from, to;
};

class Strands {
  public:
    // Lines of fewer than `fewest` points at a distance of `step` mm get none.
    Strands(const Surface& s, std::span<const Line> lines, double step, std::size_t fewest);

    std::vector<Strand> all;       // per line
    std::vector<Place> places;     // of all lines
    std::vector<Place> start;      // where the points were at first
    std::vector<std::uint32_t> of; // per point its strand

    [[nodiscard]] bool moved(std::size_t point) const;
    // The runs of points that moved.
    [[nodiscard]] std::vector<StrandRun> moved_runs(const Strand& strand) const;
    // mm2 between the old and the new place of a run; a point is compared with the old points up to `beside` away.
    [[nodiscard]] double area_moved(const Strand& strand, StrandRun run, std::ptrdiff_t beside) const;
    // The line with its moved parts replaced by the moved points.
    [[nodiscard]] Line line(const Strand& strand) const;

  private:
    const Surface& s_;
    double step_;
};

} // namespace filum::surface::curve
