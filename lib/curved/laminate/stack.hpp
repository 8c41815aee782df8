// The plies of a laminate, their texts and tables, and whether the stack is symmetric.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace filum::laminate {

// The area of a ply: on the left of closed curves, or on CAD faces; empty: everywhere.
struct Area {
    std::vector<std::vector<geom::Vec3>> curves; // mm
    std::vector<std::uint32_t> faces;            // numbers from 1

    [[nodiscard]] bool empty() const { return curves.empty() && faces.empty(); }
};

struct Ply {
    double angle = 0;    // degrees from the reference, counter-clockwise as seen from the side that the surface faces
    double spacing = 1;  // mm between its lines; also the width of its beads
    double height = 0.2; // mm, thickness
    std::uint32_t tool = 0; // of the machine
    bool under = false;     // whether it lies on the surface's back
    std::string within{};   // the word for its area, equal words for equal areas; "": everywhere
};

// "ply 3" for ply 2.
inline std::string ply_name(std::size_t k) { return "ply " + std::to_string(k + 1); }

// The plies of a text "0,45,-45,90", from the surface outwards; other members as in `like`. `mirrored`: followed by
// the same in reverse.
// Throws Error(usage) if there is none, or if a word is not a number from -360 to 360.
std::vector<Ply> plies_of(std::string_view words, const Ply& like, bool mirrored);

// The plies of a table. Rows have columns separated by blanks or tabs; the first row names them: angle, spacing,
// height, tool, side (over or under) and within (all, or any word). Missing columns are as in `like`; '#' starts a
// comment.
// Throws Error(bad_input) with `file` and the line.
std::vector<Ply> plies_of_table(std::string_view text, const std::string& file, const Ply& like, bool mirrored);

// Ply k and ply k from the end, through the thickness, are of the same angle (half a turn is none), height, spacing and
// place.
struct Symmetry {
    std::size_t unlike = 0;  // plies without their like at the same distance from the middle
    std::size_t unequal = 0; // plies of +angle more than of -angle, or the other way round, over all angles
    std::size_t first = 0;   // of the unlike, from 0
};
Symmetry symmetry(std::span<const Ply> plies);

// The plies in their order through the part, from the lowest under the surface to the highest over it.
std::vector<std::size_t> through(std::span<const Ply> plies);

} // namespace filum::laminate
