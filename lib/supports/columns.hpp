// The cross-sections of supports.  Private to lib/supports.
#pragma once

#include "supports/supports.hpp"

namespace filum::supports {

using polygon::Loops;

// Per layer what of it must be carried.
std::vector<Loops> overhangs(const std::vector<Loops>& layers, const std::vector<double>& height, const Options& o);

// Per layer where supports stand, below `over`; `interface` of it where the part is next above.
struct Columns {
    std::vector<Loops> all, interface;
};
Columns columns(const std::vector<Loops>& layers, const std::vector<Loops>& over, const Options& o);

} // namespace filum::supports
