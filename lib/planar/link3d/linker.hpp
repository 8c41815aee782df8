// Joins curves to one toolpath: chooses where each curve is entered and left, and how the nozzle gets to the next.
//
// A closed curve is cut where it is entered, so its exit lies beside its entry. From there the nozzle enters the region
// above at the nearest place of its curve: a plain lift, then a short jog that cannot cross that curve. If the region
// above is out of reach, the curve ends with a lane. It leads from the exit along the middle of the strip between two
// passes of the curve (strip_route.hpp). The lane is half a bead wide, and the beads on both sides give up its
// material. Entries drift towards the regions that come next, some regions ahead, so that such lanes stay rare
// (docs/algorithms/link3d.md).
#pragma once

#include "link3d/state.hpp"

#include <functional>

namespace filum::link3d {

// Takes regions in processing order and emits spans in printing order. Every span begins where the one before it ended.
// Keeps at most look_ahead + 1 regions; with connectors or strands it keeps all regions until finish().
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
