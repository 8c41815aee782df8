// Rings that face each other across a narrow place.
#pragma once

#include "geodesic/exact.hpp"
#include "surfpath/rings/ring.hpp"

namespace filum::surfpath::rings {

// A corner as it is taken: by its arc, or, if `over` is set, by a bridge from where it begins to where that one ends.
struct Bend {
    std::size_t ring;
    const Corner* corner;
    std::size_t scale; // of the radii of its batch
    const Bend* over = nullptr;
    Line bridge{};
};

// Finds tips of the rings at `level`, which are a spacing apart, that face each other across a neck, the way between
// them being no lower than 0.6 spacings below the level; joins them in pairs by two lines that run through the neck at
// its height.  The nearest pairs come first.
void bridge_necks(const Surface& surface, const geodesic::ExactField& field, double level, double spacing,
                  const std::vector<Ring>& rings, std::vector<Bend>& bends);

} // namespace filum::surfpath::rings
