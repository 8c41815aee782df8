// Where a plane meets the triangles: closed contours, and pieces that are left open; private to lib/slice.
#pragma once

#include "polygon/arrange.hpp"
#include "slice/open_contours.hpp"

namespace filum::slice {

struct Section {
    Loops loops;                     // closed contours, solid on the left
    std::vector<std::uint32_t> body; // of each
    std::vector<OpenContour> open;
};

// One for each layer of the chunk.
std::vector<Section> sections(const Sweep& sweep, std::size_t chunk);

// The contours of the lids' triangles at this layer; all of their length is lid.
std::vector<OpenContour> lid_contours(const Sweep& sweep, std::size_t layer);

} // namespace filum::slice
