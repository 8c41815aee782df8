// How many rings each branch of a distance gets, and at which levels.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::rings {

// What of a surface is farther than a level, as it hangs together, and the lines of that level about it.  These, by the
// level below, are the tree of the distance's maxima: where one holds two of the next level, there is a saddle.
struct Isle {
    std::uint32_t ring = 0;  // its level is (ring + 1/2) spacings
    std::uint32_t outer = 0; // that of the level below that it lies in; none at the first level
    double top = 0;          // mm: its greatest distance
    double around = 0;       // mm, of its lines
    double longest = 0;      // mm, of one of them
    geom::Vec3 at;           // on the first of them
};

// From a saddle, or a first line, up to one maximum.  At a saddle the branch goes on that leads to the higher one (of
// equals, the first); the others begin there.
struct Branch {
    std::uint32_t first = 0, last = 0; // isles: the lowest and the highest
    std::vector<double> levels;        // mm: of rings first->ring and on
    double widest = 0;                 // mm: greatest change of the spacing
    bool closed = false;               // the innermost ring lies where it covers just up to the top
    double off = 0;                    // mm that it lies beside that, if a ring is long enough there
};

struct Branching {
    double spacing = 1; // mm
    double radius = 0;  // mm: a ring is no shorter than the circumference of a circle with it
    // The path ends along the maximum of a first branch, so its innermost ring may lie a spacing below.
    bool ridge = false;
};

inline constexpr double kMostChange = 0.1; // of the spacing, at most

// The branches of `isles` (by rising rings), those with lower begins first; and per isle its branch in `of`.
// A branch's innermost ring shall lie half a spacing below the maximum, or as far in as a ring can be that is not too
// short.  Rings are moved there by a change of up to a tenth of the spacings between them, of the shortest rings first,
// as there it costs the least area (of equals, the inner one); by one more ring, or one less: what is laid twice, being
// half as bad as what is bare.  Where too few rings lie on the branch it stays as it is, and is not closed.  The first
// ring of a branch is as far from the one outside of it as that of the branch it leaves.
std::vector<Branch> branches(std::span<const Isle> isles, const Branching& options, std::vector<std::uint32_t>& of);

} // namespace filum::surfpath::rings
