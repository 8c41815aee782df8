// Several toolpaths as one.
#pragma once

#include "geom/affine.hpp"
#include "toolpath/path.hpp"

#include <limits>
#include <vector>

namespace filum::toolpath {

struct AssemblyOptions {
    double lift = 5; // mm: along the tool axis, of travels from one toolpath to the next, and above all laid before
    // Tool of each toolpath in turn, the last one also of all that follow; none: they keep their own.
    std::vector<double> tools{};
    geom::Affine place{}; // of everything; keeps lengths and angles
};

// Takes the spans of toolpaths in their order and gives back those of the job.
class Assembly {
  public:
    explicit Assembly(const AssemblyOptions& options) : o_(options) {}

    // The next toolpath begins.
    void begin();

    // The span, placed, with its stroke numbered on from the toolpaths before; the first one of a toolpath behind a
    // travel from where the last one ended: up along the tool axis there, across, and down along the axis here.  Where
    // one of the axes is not upright, across means: upright above all that was laid so far, for between two sides of a
    // part the part itself stands in the way.
    std::vector<Span> add(Span span);

  private:
    [[nodiscard]] Span travel(const Span& to) const;

    AssemblyOptions o_;
    std::size_t begun_count_ = 0;        // toolpaths
    std::uint32_t first_ = 0, next_ = 0; // strokes: of this toolpath, and behind the greatest
    bool fresh_ = false, begun_ = false;
    geom::Vec3 at_, axis_{0, 0, 1};
    double top_ = -std::numeric_limits<double>::infinity(); // mm: of all so far
};

} // namespace filum::toolpath
