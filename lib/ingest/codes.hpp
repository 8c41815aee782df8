// What the G codes of programs do, as far as a toolpath depends on it.
#pragma once

#include <cstdint>

namespace filum::ingest {

enum class Action : std::uint8_t {
    modal,        // changes how words are read, or nothing; what moves on the same line moves
    command,      // owns the words of its line; moves nothing that matters here
    move,         // G0 to G3
    home,         // G28, G30, and the G161 and G162 of MakerBot
    probe,        // G38.2 to G38.5: a move that may end early
    zero,         // G92: names the place where the tool is
    native,       // G92.1, G92.2: forgets G92
    local,        // G52: moves the origin
    work_offset,  // G10 L2 and L20: moves the origin of a work coordinate system
    work_system,  // G54 to G59.3
    machine,      // G53: the numbers of this line are the machine's own
    retract,      // G10
    give,         // G11
    not_followed, // moves, or changes where moves lead, in a way that is not followed
};

struct Code {
    Action action = Action::command;
    const char* why = ""; // of what is not followed: "a curve", for messages
};

// What one line says beside its G code.
struct LineWords {
    bool places = false;     // an axis
    bool offsets = false;    // L2 or L20
    bool machinekit = false; // the program is of Slic3r's flavour MachineKit
};

Code code_of(double g, const LineWords& line);

} // namespace filum::ingest
