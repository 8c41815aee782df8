#include "link3d/climb.hpp"

#include "link3d/entry.hpp"
#include "link3d/helix.hpp"

#include <algorithm>

namespace filum::link3d {

namespace {

using toolpath::Role;

// The entry of the front region nearest to the nozzle, in reach, for which no bead of the region lies across the way. A
// bead can lie across the way only if the region has open curves, which are entered at their ends. If one lies across
// every way, the nearest entry; settle.cpp then reports what the join crosses.
std::optional<Entry> climb_to(const State& state) {
    const auto& r = state.region();
    const Vec2 from = state.at->xy();
    const double reach = reaches(state, r).back() * (r.width + state.before.width) / 2;
    const auto nearest = nearest_entry(r, from, reach);
    if (!nearest || !r.open) return nearest;
    std::vector<char> tried(r.paths.curves.size(), 0);
    for (auto entry = nearest; entry; entry = nearest_entry(r, from, reach, tried)) {
        if (is_free(r.index, from, entry->place.point, 0, kEnds, kEnds)) return entry;
        tried[entry->place.curve] = 1;
    }
    return nearest;
}

// Length of a ramp, mm: a slope of 1 : 20, at least five bead widths (docs/algorithms/link3d.md#ramps-and-helices).
double ramp_length(const State& state) {
    const auto& r = state.region();
    return std::max(20 * (r.paths.z - state.at->z), 5 * r.width);
}

// Whether a ramp is asked for and the front region's curve is long enough for it.
bool ramps(const State& state, const Entry& entry) {
    const auto& r = state.region().paths;
    const auto& curve = r.curves[entry.place.curve];
    if (!r.stacked.empty()) return false; // its walls are two passes, half a layer apart
    return state.options.lift != Lift::plain && curve.closed && length(curve.points) > 3 * ramp_length(state);
}

// Begins a ramp: the jog to the front region's curve is its first part.
void begin_ramp(State& state, const Entry& entry) {
    const auto& r = state.region();
    Ramp& ramp = state.front.ramp;
    ramp = {ramp_length(state), geom::distance(state.at->xy(), entry.place.point), state.at->z};
    ++state.counts.ramps;
    if (ramp.lead <= kSamePoint) {
        ramp.lead = 0;
        return;
    }
    const double up = ramp.lead / ramp.length;
    const Vec3 to = at_height(entry.place.point, r.paths.z - (r.paths.z - state.at->z) * (1 - up));
    extrude(state, Role::lift, {*state.at, to}, {r.paths.height * kFaint, r.paths.height * std::max(kFaint, up)});
}

// Prints the jog to a turn of a helix. It lies on the layer below and is as thin as the beginning of a ramp.
void begin_turn(State& state, Vec2 to) {
    const double h = kFaint * state.region().paths.height;
    extrude(state, Role::lift, {*state.at, at_height(to, state.at->z + h)}, {h});
}

} // namespace

bool rises(const State& state) {
    const auto& r = state.region().paths;
    const double rise = state.at ? r.z - state.at->z : 0;
    return rise >= 0.5 * r.height && rise <= 1.5 * r.height;
}

std::optional<Entry> climb(State& state) {
    const auto& r = state.region();
    if (!state.before.printed || !rises(state)) return std::nullopt;
    auto entry = climb_to(state);
    if (!entry) return std::nullopt;
    if (state.options.interlace == Interlace::none && !state.column.lap)
        *entry = drift(state, *entry); // with interlacing, lanes lead to the planned starts
    keep_join(state, entry->place.point);
    ++state.counts.lifts;
    state.counts.lift_length += entry->place.distance;
    if (state.column.lap || winds_on(state, *entry)) {
        state.front.winds = true;
        if (entry->place.distance > kSamePoint) begin_turn(state, entry->place.point);
        return entry;
    }
    if (ramps(state, *entry)) {
        begin_ramp(state, *entry);
        return entry;
    }
    std::vector<Vec3> way{*state.at, at_height(state.at->xy(), r.paths.z)};
    if (entry->place.distance > kSamePoint) way.push_back(at_height(entry->place.point, r.paths.z));
    extrude(state, Role::lift, std::move(way));
    return entry;
}

} // namespace filum::link3d
