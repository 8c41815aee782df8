// Edges that no patch goes over.
#pragma once

#include "partition/split.hpp"

namespace filum::partition {

struct SeamOptions {
    double crease_deg = 40; // edges that bend more are seams
    bool faces = false;     // edges between CAD faces are
    double least_area = 0;  // mm2: what creases enclose that is smaller is no face of its own, if they are blunt
};

// Per half-edge 1 where the edge is a seam, in both halves.  Of creases those that end within the surface are none, and
// those around less than the least area where they bend 60 degrees or less on the mean: noise of a scan, not an edge
// of a part.  Throws Error(usage) if the sheet has no faces and they are asked for.
std::vector<char> seams(const Sheet& sheet, const SeamOptions& options);

} // namespace filum::partition
