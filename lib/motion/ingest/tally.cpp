#include "ingest/tally.hpp"

namespace filum::ingest {

Notes notes_of(const Tally& tally, const Counts& counts) {
    Notes out;
    const auto note = [&](NoteCode code, double amount, std::uint64_t count) {
        if (count > 0) out.push_back({code, amount, count});
    };
    const auto lines = [&](NoteCode code, std::uint64_t count) { note(code, static_cast<double>(count), count); };
    constexpr double kLeast = 0.5; // mm3: less comes from rounding, and from material added after travels
    const auto volume = [&](NoteCode code, double amount) { note(code, amount, amount > kLeast ? 1 : 0); };
    note(NoteCode::purge_dropped, tally.purged, tally.purged_moves);
    volume(NoteCode::extruded_standing, counts.still);
    volume(NoteCode::flow_ignored, tally.flow_off);
    lines(NoteCode::probe_assumed, tally.probes);
    lines(NoteCode::origin_assumed, tally.origins);
    lines(NoteCode::line_no_command, tally.no_code);
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
