// How a region continues the one printed before it: `sequence` decides this, and `link3d` follows it.
#pragma once

#include <cstdint>

namespace filum {

enum class Join : std::uint8_t {
    start,    // a new stroke begins
    vertical, // the stroke comes from the region below
    beside,   // the stroke comes from the brim around the region, on the same layer
};

} // namespace filum
