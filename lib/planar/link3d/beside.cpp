#include "link3d/beside.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <limits>

namespace filum::link3d {

namespace {

using toolpath::Curve;

bool crosses_no_join(const State& state, Vec2 a, Vec2 b) {
    const double z = state.region().paths.z;
    if (!misses_strands(state, at_height(a, z), at_height(b, z))) return false;
    return std::none_of(state.front.joins.begin(), state.front.joins.end(),
                        [&](const Curve& j) { return geom::cross_properly(a, b, j.points[0], j.points[1]); });
}

} // namespace

std::optional<Entry> step_in(State& state) {
    const auto& r = state.region();
    if (!beside_last(state)) return std::nullopt;
    const Vec2 from = state.at->xy();
    const auto entry = nearest_entry(r, from, reaches(state, r).back() * (r.width + state.before.width) / 2);
    if (!entry) return std::nullopt;
    const Vec2 to = entry->place.point;
    if (!leaves_freely(state, from, to) || !is_free(r.index, from, to, kMargin, 0, kEnds)) return std::nullopt;
    ++state.counts.brims;
    jog(state, *entry);
    return entry;
}

Entry hop(State& state, std::span<const char> done) {
    const auto& r = state.region();
    const Vec2 from = state.at->xy();
    const auto entry = nearest_entry(r, from, std::numeric_limits<double>::infinity(), done).value();
    const Vec2 to = entry.place.point;
    const bool near = entry.place.distance <= state.options.reach * r.width;
    if (near && is_free(r.index, from, to, kMargin, kEnds, kEnds) && crosses_no_join(state, from, to)) {
        ++state.counts.jogs;
        state.counts.jog_length += entry.place.distance;
        jog(state, entry);
    } else {
        ++state.counts.parted;
        state.notes.push_back({near ? NoteCode::break_near : NoteCode::break_far, 0, 1, r.paths.layer, from.x, from.y});
        stop_and_travel(state, to);
    }
    return entry;
}

} // namespace filum::link3d
