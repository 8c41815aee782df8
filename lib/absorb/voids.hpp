// Places of a tile that no bead covers.
#pragma once

#include "absorb/tile.hpp"

#include <vector>

namespace filum::absorb {

// Pixels that hang together.
struct Void {
    std::vector<Pixel> pixels;
    Pixel deepest; // with most bare pixels around it
};

// The voids of at least `least` pixels whose lowest pixel lies in lo .. hi, in pieces of at most `most`, the largest
// first; ties: the lower, then the left one.
std::vector<Void> voids(Tile& tile, Pixel lo, Pixel hi, std::size_t least, std::size_t most);

} // namespace filum::absorb
