// Reads the moves of a finished machine program from its text.
#pragma once

#include "collision/beads.hpp"
#include "machine/profile.hpp"

#include <string_view>

namespace filum::collision {

struct ProgramOptions {
    double width = 0, height = 0; // mm, of beads; 0: from the program's comments WIDTH: and HEIGHT:
    Vec3 shift;                   // mm, from the program's coordinates to those of the meshes
};

struct Program {
    std::vector<Move> moves; // `source` is the line, from 1
    std::vector<Solid> beads;
    std::uint64_t lines = 0;   // number of lines that move
    std::uint64_t ignored = 0; // number of other lines, without empty ones and comments
    std::uint64_t unknown = 0; // number of lines that move from or to an unknown place; they are not among the moves
};

// Supported are G0 and G1 (modal) with X, Y, Z and the profile's rotary words, in mm (G21), absolute (G90); N, F and
// the extruder word; and G92 for the extruder only. Beads are deposited where the extruder advances, or between the
// codes extrusion.on and .off of a valve, or fibre.on and .off of a pulled fibre.
// The tool is 0 at first, then the one that the codes of [tool.N] or tools.change select; its position is then
// unknown. Rotary axes are at 0 until a line moves them; after G28 X, Y and Z are unknown. The words of lines with
// other G or M codes belong to those codes.
// Coordinates are the tip in the part's frame where the profile says so: between its tcp_on and tcp_off, or everywhere
// if it names none; otherwise they are axis positions. Moves of axes are halved until, in the middle of each, the tip
// deviates from the straight line by at most 0.002 mm and the axis from its great circle by at most 0.2 degrees.
// Throws Error(bad_input) with the line for malformed words, G2, G3, G20, G53, G91, G92 of an axis that moves, and for
// beads of unknown size if no size is ever stated. Material extruded before the first size is start code, such as a
// purge line, and no bead.
Program read_program(std::string_view text, const std::string& name, const machine::Profile& profile,
                     const ProgramOptions& options);

} // namespace filum::collision
