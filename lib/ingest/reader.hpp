// A machine's program, of any slicer, as a toolpath.
#pragma once

#include "ingest/beads.hpp"
#include "ingest/tally.hpp"
#include "machine/profile.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace filum::ingest {

struct Options {
    double filament = 0;          // mm, its diameter; 0: what the program says, else the profile
    std::vector<double> bead;     // mm: width and height of beads where the program does not tell; none: it must
    bool start_code = false;      // keep what is laid before the first layer begins
    double arc_tolerance = 0.002; // mm, of the lines that an arc becomes
};

// Follows the whole program.  Moves are G0 to G3 (I J or R, P turns; in XY).  What else changes where they lead or what
// they lay is followed: G10 and G11, G17, G20 and G21, G28, G52 to G59, G90 to G92, M82 and M83, M200 D, T and M6, and
// Klipper's ACTIVATE_EXTRUDER; or it is an error that names the code, as G5, G18 with an arc, G43.4, G51, G68, M128 and
// words of axes that the profile lacks.  All other commands are counted, and their words are not looked at: they have
// flags and text.
// Places are mm as the program has them, from where it homes; on a profile with rotary axes the tip in the part's
// frame, with the tool's axis, cut so fine that the tip keeps to its line within 0.002 mm.  Material is what the
// extruder word counts, or where a valve's or a fibre's codes are open width times height times way.  The height of a
// bead is what comments say, else how far its level lies above the one below it that something was laid on.  Throws
// Error(bad_input) naming the line: words of a move without numbers, moves that are not followed, a bead of unknown
// height; or if nothing is laid at all.
Found read(std::string_view program, const std::string& name, const machine::Profile& profile, const Options& options,
           const Beads::Emit& emit);

} // namespace filum::ingest
