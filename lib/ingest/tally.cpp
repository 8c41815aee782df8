#include "ingest/tally.hpp"

namespace filum::ingest {

Notes notes_of(const Tally& tally, const Counts& counts) {
    Notes out;
    const auto note = [&](const char* what, double amount, const char* unit, std::uint64_t count) {
        if (count > 0) out.push_back({"", what, amount, unit, count});
    };
    const auto lines = [&](const char* what, std::uint64_t count) {
        note(what, static_cast<double>(count), "lines", count);
    };
    constexpr double kLeast = 0.5; // mm3: less is rounding, and what is given on top after each travel
    const auto volume = [&](const char* what, double amount) { note(what, amount, "mm3", amount > kLeast ? 1 : 0); };
    note("laid before the first layer, left out; see --start-code", tally.purged, "mm", tally.purged_moves);
    volume("pushed out while the tool stands, in no bead", counts.still);
    volume("flow changed by M221, not counted in the beads", tally.flow_off);
    lines("probing moves, taken as ending where they would at the latest", tally.probes);
    lines("origins moved by G10, taken as 0 before", tally.origins);
    lines("lines that are no commands, passed over", tally.no_code);
    return out;
}

Facts facts_of(const Tally& tally, const Counts& counts) {
    Facts out;
    const auto fact = [&](const char* what, double value, const char* unit = "") {
        out.push_back({"", what, value, unit});
    };
    fact("strokes", static_cast<double>(counts.strokes), "strokes");
    fact("stops", static_cast<double>(counts.stops));
    fact("travels", static_cast<double>(counts.travels));
    fact("retractions", static_cast<double>(counts.retractions));
    fact("extruded", counts.extruded, "mm");
    fact("travelled", counts.travelled, "mm");
    fact("volume", counts.volume, "mm3");
    fact("moves", static_cast<double>(tally.moves));
    fact("arcs", static_cast<double>(tally.arcs));
    fact("other-lines", static_cast<double>(tally.ignored));
    return out;
}

} // namespace filum::ingest
