// The isolines that become rings: each branch of the distance has its own levels.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/rings/branches.hpp"

namespace filum::surfpath::rings {

using surface::Surface;

struct Levels {
    std::vector<double> at;                    // mm, ascending
    std::vector<std::uint32_t> ring;           // per level: number of rings outside of its own
    std::vector<surface::Isoline> lines;       // closed, in the order of levels
    std::vector<std::uint32_t> of;             // per line: index of its level
    std::vector<geodesic::EdgePlace> begins{}; // per line
};

// The isolines of all branches at their levels (branches.hpp). Facts: "branches"; "branches-open", those whose
// innermost ring cannot be moved to the maximum although a ring is long enough there; "spacing-change", the greatest,
// as a share. A note gives the open ones, with the total width of the strips along their maxima that are void or
// overlap, and the place of the widest.
Levels levels(const surface::Surface& surface, const geodesic::ExactField& field, const BranchOptions& options,
              Facts& facts, Notes& notes);

} // namespace filum::surfpath::rings
