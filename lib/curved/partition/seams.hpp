// Seams: edges that no patch may contain in its interior.
#pragma once

#include "partition/split.hpp"

namespace filum::partition {

struct SeamOptions {
    double crease_deg = 40; // edges that bend more are seams
    bool faces = false;     // whether edges between CAD faces are seams
    double detail_area = 0; // mm2: smaller areas enclosed by creases are noise
    double least_area = 0;  // mm2: smaller areas enclosed by blunt creases are not faces of their own
};

// Per half-edge whether its edge is a seam. Creases that end inside the surface do not count; those around less than
// the detail area do not count either, and those around less than the least area do not if they bend 60 degrees or less
// on average, which are noise of a scan. Throws Error(usage) if `faces` is set and the sheet has none.
std::vector<char> seams(const Sheet& sheet, const SeamOptions& options);

} // namespace filum::partition
