// Reads a machine's program, from any slicer, as a toolpath.
#pragma once

#include "ingest/beads.hpp"
#include "ingest/tally.hpp"
#include "machine/profile.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace filum::ingest {

struct Options {
    double filament = 0;      // mm, diameter; 0: as in the program, or else as in the profile
    std::vector<double> bead; // mm: width and height of beads that the program does not give; empty: it must give them
    bool start_code = false;  // keep beads before the first layer
    double arc_tolerance = 0.002; // mm, largest deviation of lines from their arc
};

// Follows the whole program and emits its spans.
//
// Moves are G0 to G3 (with I J or R, and P turns; in XY). These codes are followed, too, as they change where moves
// lead or what they deposit: G10, G11, G17, G20, G21, G28, G52 to G59, G90 to G92, M82, M83, M200 D, T, M6, and
// Klipper's ACTIVATE_EXTRUDER. Other codes that would change moves are errors that name the code: G5, G18 with an arc,
// G43.4, G51, G68, M128. So are words of axes that the profile lacks. All other commands are counted. Their words are
// not read, as they may be flags and text.
//
// Positions are in mm as in the program, relative to its home. On a profile with rotary axes, a span holds the tip in
// the part's frame and the tool's axis. It is cut so finely that the tip keeps to its line within 0.002 mm.
//
// The volume of a bead is what the extruder word counts. Where codes open a valve or start a fibre, it is width times
// height times length. The height of a bead comes from comments. Without them it is the distance between its level and
// the next lower level that has a bead.
//
// Throws Error(bad_input) with the line for words of a move without numbers, moves that are not followed, and beads of
// unknown height. It is thrown, too, if the program deposits nothing.
ReadResult read(std::string_view program, const std::string& name, const machine::Profile& profile,
                const Options& options, const Beads::Emit& emit);

} // namespace filum::ingest
