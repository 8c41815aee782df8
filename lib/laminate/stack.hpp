// What plies a laminate is made of, and whether it is symmetric.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace filum::laminate {

// Where a ply lies: to the left of closed curves, or on CAD faces; with neither everywhere.
struct Within {
    std::vector<std::vector<geom::Vec3>> curves; // mm
    std::vector<std::uint32_t> faces;            // by number, from 1

    [[nodiscard]] bool empty() const { return curves.empty() && faces.empty(); }
};

struct Ply {
    double angle = 0;       // degrees from the reference, counter-clockwise, seen from the side that the surface faces
    double spacing = 1;     // mm between its lines, the width of its beads
    double height = 0.2;    // mm that it is thick
    std::uint32_t tool = 0; // of the machine
    bool under = false;     // it lies on the surface's back
    std::string within{};   // what a table says of where it lies: a word, the same for the same place; "": everywhere
};

// "ply 3" for ply 2.
inline std::string ply_name(std::size_t k) { return "ply " + std::to_string(k + 1); }

// The plies of a text "0,45,-45,90", from the surface outwards; all else as `like` has it.  `mirrored`: followed by the
// same in reverse.  Throws Error(usage) if there is none, or a word is no number from -360 to 360.
std::vector<Ply> plies_of(std::string_view words, const Ply& like, bool mirrored);

// The plies of a table: lines of columns between blanks or tabs, the first line names them, out of angle, spacing,
// height, tool, side (over or under) and within (all, or any word); what has no column is as `like` has it; '#' begins
// a remark. Throws Error(bad_input) naming `file` and the line.
std::vector<Ply> plies_of_table(std::string_view text, const std::string& file, const Ply& like, bool mirrored);

// Ply k and ply k from the end, through the thickness, are of the same angle (half a turn is none), height, spacing and
// place.
struct Symmetry {
    std::size_t unlike = 0;  // plies without their like at the same distance from the middle
    std::size_t unequal = 0; // plies of +angle more than of -angle, or the other way round, over all angles
    std::size_t first = 0;   // of the unlike, from 0
};
Symmetry symmetry(std::span<const Ply> plies);

// The plies in the order in which they lie in the part, from the lowest under the surface to the highest over it.
std::vector<std::size_t> through(std::span<const Ply> plies);

} // namespace filum::laminate
