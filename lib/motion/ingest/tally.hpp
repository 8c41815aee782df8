// Counts of a program's lines beside beads and travels, and the notes and facts made from them.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "ingest/beads.hpp"

namespace filum::ingest {

struct Tally {
    std::uint64_t moves = 0, arcs = 0; // numbers of lines
    std::uint64_t ignored = 0;         // lines that do not move and do not change how others are read
    std::uint64_t no_code = 0;         // lines that are not commands and not comments
    std::uint64_t probes = 0;          // moves that end on contact
    std::uint64_t origins = 0;         // G10 L2 for coordinates that were in use
    std::uint64_t purged_moves = 0;    // beads dropped before the first layer
    double purged = 0;                 // mm, length of these beads
    double flow_off = 0;               // mm3 that M221 adds to or removes from the beads
};

Notes notes_of(const Tally& tally, const Counts& counts); // without the stage
Facts facts_of(const Tally& tally, const Counts& counts);

struct ReadResult {
    Counts counts;
    Notes notes; // without the stage
    Facts facts;
};

} // namespace filum::ingest
