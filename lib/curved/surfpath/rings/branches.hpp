// The number and the levels of rings on each branch of a distance field.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::rings {

// A connected component of the superlevel set {distance > level}, and the isolines around it. Isles form a tree, each
// inside one of the level below; an isle that contains two of the next level contains a saddle.
struct Isle {
    std::uint32_t ring = 0;  // its level is (ring + 1/2) spacings
    std::uint32_t outer = 0; // isle of the level below that contains it; kNone at the first level
    double top = 0;          // mm: the greatest distance in it
    double around = 0;       // mm: total length of its isolines
    double longest = 0;      // mm: length of the longest of them
    geom::Vec3 at;           // a point of the first of them
};

// The isles from a saddle, or from the first level, up to one maximum. At a saddle the branch with the higher maximum
// continues (ties: the first); the others begin there.
struct Branch {
    std::uint32_t first = 0, last = 0; // its lowest and its highest isle
    std::vector<double> levels;        // mm: of its rings, from that of `first` on
    double widest = 0;                 // mm: the greatest change of a spacing
    bool closed = false;               // whether the innermost ring covers exactly up to the maximum
    double off = 0; // mm: distance of the innermost ring from that place, if a ring is long enough there
};

struct BranchOptions {
    double spacing = 1; // mm
    double radius = 0;  // mm: rings are at least as long as a circle of this radius
    // The path will end along the maximum of a first branch, so its innermost ring may be a spacing below it.
    bool ridge = false;
};

// The branches of `isles` (which are sorted by rings), in the order of their first isles; `of` is set to the branch of
// each isle.
// The innermost ring of a branch should be half a spacing below the maximum, or as far in as a ring of sufficient
// length can be. To move it there, spacings change by up to a tenth, beginning with the shortest rings, where that
// costs the least area (ties: the inner one), and there may be one ring more or one less. Overlap costs half as much
// as void. A branch with too few rings for that is not changed, and not closed. The first ring of a branch has the
// same distance from the ring outside as that of the branch from which it departs.
std::vector<Branch> branches(std::span<const Isle> isles, const BranchOptions& options, std::vector<std::uint32_t>& of);

} // namespace filum::surfpath::rings
