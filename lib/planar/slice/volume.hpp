// Compares the volume of the layers with that of the mesh, so that no loss goes unreported.
#pragma once

#include "slice/slice.hpp"

#include <optional>
#include <span>

namespace filum::slice {

// The solid volume of a part, measured independently of its layers: by planes of its own, at least two in each sampled
// layer. Where the contours of a plane close, rows measure the area inside. Elsewhere random points are tested: a point
// is solid if the winding number of the surface exceeds 1/2. A point is undecided if its winding number differs by more
// than a quarter from every whole number, or is clearly negative.
struct VolumeSamples {
    std::vector<std::size_t> layers;      // the sampled layers, ascending; all layers if there are few
    std::vector<double> solid, undecided; // per sampled layer, mm3
    std::vector<geom::Vec2> where;        // per sampled layer: an undecided point
    double baseless = 0;                  // mm3 that stay undecided even if triangles are missing everywhere
};
VolumeSamples measure(const Sweep& sweep, std::size_t planes, std::size_t points, int threads);

// Measures a mesh that is not closed; returns nothing for a closed one. A note reports the undecided volume if it
// exceeds 1.5 % of the solid. Another note reports the volume that flat lids on its holes may have lost. Throws
// Error(bad_input) if more is undecided than solid, as for random triangles or a sheet.
std::optional<VolumeSamples> judge(const Sweep& sweep, int threads, Notes& notes);

// Adds a note if the printed volume is more than 1.5 % off, naming the layer with the largest difference. Also adds a
// note on each empty layer between others. `area` is the area of each layer, mm2; `measured` is the result of judge().
// A closed mesh is measured only if the volumes of its shells do not already agree with the print.
void compare(const Sweep& sweep, const std::optional<VolumeSamples>& measured, std::span<const double> area,
             int threads, Notes& notes);

} // namespace filum::slice
