// Layers of bodies whose tool prints several layers of the job at once.
//
// A tool whose height is n times the layer height prints one layer where others print n. Its layers are counted from
// the bottom of the lowest of its bodies, and anew from each height at which one of them has a floor or a roof wider
// than a bead. So what is left below a floor, a roof or an end is one lower layer. Each layer is cut at the middle of
// its own height. What it covers is left out of the layers of other tools beside it, and what it leaves of its body
// along their border they fill. So bodies do not overlap, and no gap opens along slanted borders: these get steps as
// high as the layer.
#pragma once

#include "app/slice/plate.hpp"

namespace filum::app::slice {

// The number of layers of the job that a layer of `height` mm covers. Throws Error(usage) if it is no whole number up
// to polygon::kMostLayers, and names the next heights that are possible. `item`: the item of --body.
std::uint32_t layers_of_height(const std::string& item, double height, const filum::slice::Options& options);

// One layer of a body, from layer `first` to `last` of the job.
struct HighLayer {
    std::size_t body = 0, first = 0, last = 0;
    double height = 0, plane = 0; // mm
    std::uint32_t skipped = 0;    // layers of the job below that the body skips
    polygon::Loops area;          // with all copies
};

// The high layers of all bodies, with the bodies that print them.
class HighLayers {
  public:
    HighLayers() = default;
    // Cuts the bodies whose `layers` is above 1, from `bottom` (the layer at which --cut-below begins) to `end`.
    HighLayers(const std::vector<BedPart>& bodies, std::span<const filum::slice::Level> levels, std::size_t bottom,
               std::size_t end, const Options& options, int threads);

    [[nodiscard]] bool any() const { return !layers_.empty(); }
    // The layer of a body that covers layer i of the job; null if it has none.
    [[nodiscard]] const HighLayer* of(std::size_t body, std::size_t i) const;
    // Gives layer i of the other bodies the border that the high layers leave them. `contours`: per body, the areas on
    // layer i, which do not overlap if their tools differ; those of bodies with high layers become empty.
    void share(std::size_t i, const std::vector<BedPart>& bodies, std::vector<polygon::Loops>& contours) const;

  private:
    std::vector<HighLayer> layers_;
    std::vector<std::vector<std::int64_t>> at_; // per body and layer of the job: index in layers_, -1: none
};

} // namespace filum::app::slice
