// Curves to one toolpath: where each is entered and left, and how one gets from each to the next.
//
// A closed curve is cut where it is entered, so its exit lies beside its entry.  From there a region above is entered
// at the nearest place of its curve: a plain lift, then a short jog that cannot cross that curve.  If the region above
// is out of reach, a lane is laid from the exit along the middle of the strip between two lanes of the curve
// (strip_route.hpp), at half a bead's width, and the beads on both sides give up what it deposits.  Looking some
// regions ahead, entries drift towards where the column goes, so that such lanes stay rare (docs/algorithms/link3d.md).
#pragma once

#include "link3d/state.hpp"

#include <functional>

namespace filum::link3d {

// Takes the regions in processing order, gives the spans in printing order; every span begins where the one before it
// ended.  Keeps at most look_ahead + 1 regions, all of them with connectors outside.
class Linker {
  public:
    using Emit = std::function<void(const toolpath::Span&)>;
    explicit Linker(const Options& options) : state_(options) {}

    void add(toolpath::RegionPaths region, const Emit& emit, Notes& notes);
    void finish(const Emit& emit, Notes& notes); // prints what is still waiting
    [[nodiscard]] const Counts& counts() const { return state_.counts; }

  private:
    void print_front(const Emit& emit, Notes& notes);

    State state_;
};

} // namespace filum::link3d
