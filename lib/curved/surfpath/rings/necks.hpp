// Bridges between rings that face each other across a narrow place.
#pragma once

#include "geodesic/exact.hpp"
#include "surfpath/rings/ring.hpp"

namespace filum::surfpath::rings {

// A corner with its replacement: the corner's arc or, if `bridged_to` is set, a bridge from the start of this corner
// to the end of that one.
struct RoundedCorner {
    std::size_t ring;
    const Corner* corner;
    std::size_t scale; // index of the radius in its batch
    const RoundedCorner* bridged_to = nullptr;
    Line bridge{};
};

// Finds pairs of tips of the rings at `level` that face each other across a neck whose lowest point is at most 0.6
// spacings below the level, and sets two bridges for each, which run through the neck at its height. Rings are a
// spacing apart. The nearest pairs come first.
void bridge_necks(const Surface& surface, const geodesic::ExactField& field, double level, double spacing,
                  const std::vector<Ring>& rings, std::vector<RoundedCorner>& bends);

} // namespace filum::surfpath::rings
