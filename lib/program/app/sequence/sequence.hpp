// What every order of regions shares: reads all regions, orders them, and writes them with their strokes.
#pragma once

#include "cli/command.hpp"
#include "machine/heads.hpp"
#include "sequence/sequence.hpp"

namespace filum::app::sequence {

struct Work {
    filum::sequence::Options how; // `how.heads` are those of `head`
    machine::HeadChoice head;
    double clearance = 0; // mm that the heads keep from finished regions
    std::string pause_at; // machine::parse_pauses; empty: no pause
    std::string ends;     // file for a table with the end of every stroke; empty: none
    bool report = false;  // print the facts
};

// Reads Regions and writes them in their order. Throws Error as machine::heads, parse_pauses and the streams do.
void run(const Work& work, const cli::Io& io);

} // namespace filum::app::sequence
