// Bead lines that fill one connected region.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

namespace filum::fill {

struct Options {
    double bead_width = 0.4; // mm
};

toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

} // namespace filum::fill
