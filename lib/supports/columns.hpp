// The cross-sections of supports.  Private to lib/supports.
#pragma once

#include "supports/supports.hpp"

namespace filum::supports {

using polygon::Loops;

// Per layer what of it must be carried.
std::vector<Loops> overhangs(const std::vector<Loops>& layers, const std::vector<double>& height, const Options& o);

// By how much, mm, the outline of a column lies inside that of the layer above it, which is `height` high: as much as
// the taper's angle says, but never so much that a bead hangs.
double taper(double height, const Options& o);

// Per layer where supports stand, below `over`; `interface` of it where the part is next above.
struct Columns {
    std::vector<Loops> all, interface;
};
Columns columns(const std::vector<Loops>& layers, const std::vector<double>& height, const std::vector<Loops>& over,
                const Options& o);

} // namespace filum::supports
