// Combines several toolpaths into one.
#pragma once

#include "geom/affine.hpp"
#include "toolpath/path.hpp"

#include <limits>
#include <vector>

namespace filum::toolpath {

struct AssemblyOptions {
    double lift = 5; // mm: height along the tool axis of travels between toolpaths, and above all earlier material
    // The tool of each toolpath, by order; the last entry also applies to all that follow; empty: tools stay.
    std::vector<double> tools{};
    geom::Affine place{}; // applied to everything; must preserve lengths and angles
};

// Takes the spans of the toolpaths in their order and returns those of the combined toolpath.
class Assembly {
  public:
    explicit Assembly(const AssemblyOptions& options) : o_(options) {}

    // Starts the next toolpath.
    void begin();

    // The span, transformed, with stroke numbers that continue those of the earlier toolpaths. The first span of a
    // toolpath follows a travel from the end of the last one: up along the tool axis there, across, and down along the
    // axis here. If one of the axes is not upright, the travel across is above all earlier material, because the part
    // itself may be between two of its sides.
    std::vector<Span> add(Span span);

  private:
    [[nodiscard]] Span travel(const Span& to) const;

    AssemblyOptions o_;
    std::size_t begun_count_ = 0;        // number of toolpaths
    std::uint32_t first_ = 0, next_ = 0; // strokes: offset of this toolpath, and one more than the greatest number
    bool fresh_ = false, begun_ = false;
    geom::Vec3 at_, axis_{0, 0, 1};
    double top_ = -std::numeric_limits<double>::infinity(); // mm: greatest z of all spans so far
};

} // namespace filum::toolpath
