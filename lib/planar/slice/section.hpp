// Cuts the triangles with planes into closed contours and open pieces; private to lib/planar/slice.
#pragma once

#include "polygon/arrange.hpp"
#include "slice/open_contours.hpp"

namespace filum::slice {

struct Section {
    Loops loops;                     // closed contours, solid on the left
    std::vector<std::uint32_t> body; // per loop: its body
    std::vector<OpenContour> open;
};

// The sections of a chunk, one per layer.
std::vector<Section> sections(const Sweep& sweep, std::size_t chunk);

// The contours of the lids' triangles at this layer.  All of their length counts as lid.
std::vector<OpenContour> lid_contours(const Sweep& sweep, std::size_t layer);

} // namespace filum::slice
