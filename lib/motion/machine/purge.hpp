// How a tool is purged after it takes over: material that is old or mixed goes to a place beside the part.
#pragma once

#include "geom/vec.hpp"

#include <string>

namespace filum::machine {

class Document;
struct Bed;

struct Purge {
    double volume = 0;                   // mm3, least volume after a change; 0: none
    double speed = 1;                    // mm3/s
    geom::Vec2 place;                    // of the tip, in the machine's coordinates
    double height = 1;                   // mm, of the tip above z = 0 while material comes out
    std::string wait = "G4 P{purge_ms}"; // valves: the codes that wait while the valve is open
    std::string after;                   // codes afterwards, such as a wipe
};

// Reads the keys of [purge].  Fails for a volume without a place, a place outside of `bed`, and a machine on which the
// tip's place is not that of its axes (`rotary`).
void read_purge(Document& doc, const Bed& bed, bool rotary, Purge& p);

} // namespace filum::machine
