// What a program held beside beads and travels, and what is to be reported of it.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "ingest/beads.hpp"

namespace filum::ingest {

struct Tally {
    std::uint64_t moves = 0, arcs = 0; // lines
    std::uint64_t ignored = 0;         // lines that neither move nor change how others are read
    std::uint64_t no_code = 0;         // lines that are neither commands nor comments
    std::uint64_t probes = 0;          // moves that end where something is met
    std::uint64_t origins = 0;         // G10 L2 of coordinates that were in use
    std::uint64_t purged_moves = 0;    // before the first layer
    double purged = 0;                 // mm, theirs
    double flow_off = 0;               // mm3 that M221 adds to or takes from the beads
};

Notes notes_of(const Tally& tally, const Counts& counts); // without the stage
Facts facts_of(const Tally& tally, const Counts& counts);

struct Found {
    Counts counts;
    Notes notes; // without the stage
    Facts facts;
};

} // namespace filum::ingest
