#include "link3d/curve.hpp"

#include "link3d/connecting_lane.hpp"
#include "link3d/features.hpp"
#include "link3d/helix.hpp"
#include "link3d/shift.hpp"

#include <utility>

namespace filum::link3d {

namespace {

using toolpath::Curve;
using toolpath::Role;
using toolpath::Span;

// Prints a bead of the front region: with walls in two passes if the region has such walls, otherwise with the ramp.
void print(State& state, const Bead& bead, const Ramp& ramp) {
    const auto& r = state.region();
    auto& walls = state.front.stacked;
    if (!walls && !r.paths.stacked.empty()) walls.emplace(r.paths.stacked);
    SpatialBead raised = walls ? walls->lay(bead, r.paths.z, r.paths.height, r.width / 2)
                               : lay(bead, r.paths.z, r.paths.height, ramp, r.width / 2);
    if (geom::distance(raised.points.front(), *state.at) < kSamePoint) raised.points.front() = *state.at; // spans join
    Span out = span(state, Role::bead);
    out.points = std::move(raised.points);
    out.width = std::move(raised.width);
    out.height = std::move(raised.height);
    emit_by_feature(std::move(out), r.paths.curves, r.index, [&](const Span& piece) { put(state, piece); });
}

// The lane that moves the start of the next layer. Nothing if no scheme asks for it, or if the bead ends far enough
// away anyway. Nothing, with a note, if there is no such lane.
std::optional<std::vector<Vec2>> lane_to_start(State& state, std::uint32_t c, const Bead& bead) {
    const auto& r = state.region().paths;
    if (state.front.next != NextPlace::above || leads_in(state) || !r.curves[c].closed ||
        state.options.interlace == Interlace::none || apart(state, bead))
        return std::nullopt;
    auto way = shift(state, c, bead);
    if (way) {
        ++state.counts.shifts;
        state.counts.shift_length += length(*way);
    } else {
        ++state.counts.kept;
        const Vec2 at = state.front.start;
        state.notes.push_back({NoteCode::interlace_impossible, 0, 1, r.layer, at.x, at.y});
    }
    return way;
}

// Prints the front region's only curve as a turn of a helix.
void print_turn(State& state, const Entry& entry) {
    const bool goes_on = winds_on(state, entry);
    Bead end = wind(state, entry, goes_on);
    if (goes_on) return;
    const auto lane = leave(state, entry.place.curve, end, [&] { return end; });
    if (state.options.connect != Connect::stop)
        keep_lines(state, SegmentIndex(as_printed(state, entry.place.curve, end, lane ? *lane : std::vector<Vec2>{})));
    if (lane) lay_lane(state, *lane);
}

} // namespace

void print_curve(State& state, const Entry& entry, bool last) {
    if (std::exchange(state.front.winds, false)) return print_turn(state, entry);
    const auto& r = state.region();
    const std::uint32_t c = entry.place.curve;
    const Curve& curve = r.paths.curves[c];
    const Ramp ramp = std::exchange(state.front.ramp, {});
    const auto bead = [&](bool against) {
        Bead b = !curve.closed     ? run(curve, entry.against)
                 : ramp.length > 0 ? cut_over(curve, entry.place, against, ramp.length - ramp.lead)
                                   : cut(curve, entry.place, against, cut_gap(curve));
        if (state.front.pin && curve.closed) pin(b, *state.front.pin, kOn);
        return b;
    };
    const bool turn = state.options.alternate_direction && r.paths.own_layer() % 2 != 0;
    Bead out = bead(turn);
    std::optional<std::vector<Vec2>> way;
    if (last) way = lane_to_start(state, c, out);
    if (last && !way) way = leave(state, c, out, [&] { return curve.closed ? bead(!turn) : out; });
    if (way)
        thin_beside(out, *way, kThin * r.width, r.width, kThin, SegmentCells(as_printed(state, c, out)),
                    state.front.pin);
    if (last && (state.options.connect != Connect::stop || leads_in(state)))
        keep_lines(state, SegmentIndex(as_printed(state, c, out, way ? *way : std::vector<Vec2>{})));
    print(state, out, ramp);
    if (way) lay_lane(state, *way);
}

} // namespace filum::link3d
