// The moves of a finished machine program, read from its text alone.
#pragma once

#include "collision/beads.hpp"
#include "machine/profile.hpp"

#include <string_view>

namespace filum::collision {

struct ProgramOptions {
    double width = 0, height = 0; // mm, of beads; 0: what the program's comments WIDTH: and HEIGHT: say
    Vec3 shift;                   // mm: from the program's places to those of the meshes
};

struct Program {
    std::vector<Move> moves; // their source is the line, counted from 1
    std::vector<Solid> beads;
    std::uint64_t lines = 0;   // lines that move
    std::uint64_t ignored = 0; // other lines that are neither empty nor comments
    std::uint64_t unknown = 0; // lines that move from or to a place that is not known yet; not among the moves
};

// G0 and G1 (modal) with X, Y, Z and the profile's rotary words, in mm (G21), absolute (G90); N, F and the extruder
// word are understood, G92 for the extruder only.  Material is laid where the extruder word grows, or between the
// codes extrusion.on and .off of a valve, fibre.on and .off of a fibre that is pulled; of the tool in use: tool 0
// first, then the one that the codes of [tool.N] or tools.change take, after which nobody knows where it is.  Rotary
// axes stand at 0 until a line says otherwise; after G28 nobody knows where X, Y and Z are.  The words of lines with
// other G or M codes are those codes' own. Numbers are the tip in the part's frame where the profile says so, from its
// tcp_on to its tcp_off or all along if it names none; else they are where the axes stand.  From there moves are cut
// until, in their middle, the tip leaves the straight line between the ends by at most 0.002 mm and the axis its great
// circle by at most 0.2 degrees. Throws Error(bad_input) with the line: malformed words, G2, G3, G20, G53, G91, G92 of
// an axis that moves, beads of unknown size.
Program read_program(std::string_view text, const std::string& name, const machine::Profile& profile,
                     const ProgramOptions& options);

} // namespace filum::collision
