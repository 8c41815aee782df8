// Cross-sections of supports, layer by layer. Private to lib/planar/supports.
#pragma once

#include "supports/supports.hpp"

namespace filum::supports {

using polygon::Loops;

// The overhangs of each layer: the areas farther from the layer below than the angle allows, grown to where supports
// must stand. `height` is the height of each layer in mm.
std::vector<Loops> overhangs(const std::vector<Loops>& layers, const std::vector<double>& height, const Options& o);

// How far, in mm, the outline of a column lies inside that of the layer above it, which is `height` mm high. The angle
// of the taper decides, up to half a bead, beyond which a bead would hang.
double taper(double height, const Options& o);

// Per layer: all areas where supports stand, and the `interface` areas among them, which lie next below the part.
struct Columns {
    std::vector<Loops> all, interface;
};
// The columns below the overhangs `over`; `height` is the height of each layer in mm.
Columns columns(const std::vector<Loops>& layers, const std::vector<double>& height, const std::vector<Loops>& over,
                const Options& o);

} // namespace filum::supports
