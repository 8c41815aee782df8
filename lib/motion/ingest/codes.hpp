// The actions of G codes, as far as a toolpath depends on them.
#pragma once

#include <cstdint>

namespace filum::ingest {

enum class Action : std::uint8_t {
    modal,        // changes how words are read, or nothing; words of the same line still move axes
    command,      // owns the words of its line; moves nothing relevant
    move,         // G0 to G3
    home,         // G28, G30, and the G161 and G162 of MakerBot
    probe,        // G38.2 to G38.5: a move that may end early
    zero,         // G92: gives the current position new coordinates
    native,       // G92.1, G92.2: cancels G92
    local,        // G52: moves the origin
    work_offset,  // G10 L2 and L20: moves the origin of a work coordinate system
    work_system,  // G54 to G59.3
    machine,      // G53: this line is in machine coordinates
    retract,      // G10
    give,         // G11
    not_followed, // moves, or changes later moves, in an unsupported way
};

struct Code {
    Action action = Action::command;
    const char* why = ""; // for not_followed: its name in messages, as "a curve"
};

// The context of a G code on its line.
struct LineWords {
    bool places = false;     // the line has a number for an axis
    bool offsets = false;    // the line has L2 or L20
    bool machinekit = false; // the program is of Slic3r's flavour MachineKit
};

Code code_of(double g, const LineWords& line);

} // namespace filum::ingest
