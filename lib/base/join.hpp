// How a region continues the one printed just before it: decided by `sequence`, obeyed by `link3d`.
#pragma once

#include <cstdint>

namespace filum {

enum class Join : std::uint8_t {
    start,    // it does not: a new stroke begins
    vertical, // from the region below it
    beside,   // from the brim about it, on the same layer
};

} // namespace filum
