// Lines of equal distance for rings: each branch of the distance at its own levels.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/rings/branches.hpp"

namespace filum::surfpath::rings {

using surface::Surface;

struct Levels {
    std::vector<double> at;                 // mm, ascending
    std::vector<std::uint32_t> ring;        // per level: how many rings lie outside of its own
    std::vector<surface::Isoline> lines;    // closed, by levels
    std::vector<std::uint32_t> of;          // per line: its level, by number
    std::vector<geodesic::OnEdge> begins{}; // per line
};

// The rings of a distance (branches.hpp).  Facts "branches"; "branches-open", of how many the innermost ring cannot be
// brought up to the maximum, though one is long enough; "spacing-change", the greatest, as a share.  Notes the open
// ones: how wide the strips along these maxima are in sum that stay bare or are laid twice, the widest with its place.
Levels levels(const surface::Surface& surface, const geodesic::ExactField& field, const Branching& options,
              Facts& facts, Notes& notes);

} // namespace filum::surfpath::rings
