#include "link3d/state.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

using toolpath::Curve;
using toolpath::Role;
using toolpath::Span;

std::size_t climbing(const State& state) {
    std::size_t n = 0;
    while (static_cast<std::int64_t>(n) < state.options.look_ahead && n + 1 < state.window.size() &&
           goes_on(state.window[n + 1]) && !state.window[n + 1].paths.curves.empty())
        ++n;
    return n;
}

bool leads_in(const State& state) { return state.window.size() > 1 && state.window[1].paths.join == Join::beside; }

bool beside_last(const State& state) {
    const double z = state.region().paths.z;
    return state.before.printed && !state.before.lines.empty() && std::abs(state.before.z - z) <= 1e-6 &&
           std::abs(state.at->z - z) <= 1e-6;
}

void keep_lines(State& state, SegmentIndex as_printed) {
    const double z = state.region().paths.z;
    if (std::abs(std::exchange(state.before.z, z) - z) > 1e-6) state.before.lines.clear();
    state.before.lines.push_back(std::move(as_printed));
}

bool leaves_freely(const State& state, Vec2 a, Vec2 b) {
    const auto& lines = state.before.lines;
    return std::all_of(lines.begin(), lines.end(), [&](const SegmentIndex& i) {
        return is_free(i, a, b, kMargin, &i == &lines.back() ? kEnds : 0, 0);
    });
}

bool misses_strands(const State& state, Vec3 a, Vec3 b) {
    const double thick = 0.99 * state.region().paths.height;
    return std::none_of(state.strands.begin(), state.strands.end(), [&](const auto& s) {
        const auto& [c, d] = s;
        return std::min(a.z, b.z) < std::max(c.z, d.z) + thick && std::min(c.z, d.z) < std::max(a.z, b.z) + thick &&
               geom::cross_properly(a.xy(), b.xy(), c.xy(), d.xy());
    });
}

std::array<double, 2> reaches(const State& state, const WaitingRegion& to) {
    const double reach = state.options.reach;
    if (to.paths.join == Join::beside) return {reach, reach};
    return {std::min(reach, 0.6), to.open ? reach : std::min(reach, 1.0)};
}

std::vector<Curve> as_printed(const State& state, std::uint32_t c, const Bead& bead, const std::vector<Vec2>& lane) {
    std::vector<Curve> curves = state.region().paths.curves;
    curves[c] = {false, bead.points, bead.width};
    curves.insert(curves.end(), state.front.joins.begin(), state.front.joins.end());
    if (lane.size() > 1) curves.push_back({false, lane, {state.region().width}});
    return curves;
}

Span span(const State& state, Role role) {
    const auto& r = state.region().paths;
    Span out{role, state.stroke, r.layer, r.region, {}, {}, {}};
    out.tool = r.tool;
    out.body = r.body;
    return out;
}

void put(State& state, Span span) {
    state.at = span.points.back();
    state.front.spans.push_back(std::move(span));
}

void extrude(State& state, Role role, std::vector<Vec3> points, std::vector<double> height) {
    Span out = span(state, role);
    out.points = std::move(points);
    out.width = {kThin * state.region().width};
    if (height.empty()) height = {state.region().paths.height};
    out.height = std::move(height);
    put(state, std::move(out));
}

void keep_join(State& state, Vec2 to) {
    state.front.joins.push_back({false, {state.at->xy(), to}, {kThin * state.region().width}});
}

void jog(State& state, const Entry& entry) {
    const Vec2 to = entry.place.point;
    keep_join(state, to);
    if (entry.place.distance > kSamePoint)
        extrude(state, Role::jog, {*state.at, at_height(to, state.region().paths.z)});
}

void stop_and_travel(State& state, Vec2 to) {
    const Vec3 there = at_height(to, state.region().paths.z);
    if (state.at) {
        Span out = span(state, Role::travel);
        out.points = travel(state.printed, *state.at, there, state.options.head);
        state.counts.travel_length += length(out.points);
        ++state.counts.breaks;
        ++state.stroke;
        put(state, std::move(out));
    } else {
        state.at = there;
    }
    ++state.counts.strokes;
    state.printed.begin();
}

} // namespace filum::link3d
