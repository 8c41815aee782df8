#include "link3d/connecting_lane.hpp"

#include "link3d/connector.hpp"
#include "link3d/strip_route.hpp"

#include <algorithm>
#include <utility>

namespace filum::link3d {

namespace {

using toolpath::Role;

constexpr double kDrift = 0.5; // bead widths per layer that an entry is expected to drift

// How many of the next regions are in reach of p, including the drift of entries until then; 0 if fewer than `least`.
int rank_above(const State& state, Vec2 p, int least, double reach) {
    const int all = static_cast<int>(climbing(state));
    const auto in_reach = [&](int k) {
        const auto& next = state.window[static_cast<std::size_t>(k) + 1];
        return nearest_entry(next, p, (reach + kDrift * k) * (state.window[0].width + next.width) / 2).has_value();
    };
    if (least > all || !in_reach(least - 1))
        return 0; // the last one that must be in reach first: most places fail there
    int k = 0;
    while (k < all && (k == least - 1 || in_reach(k))) ++k;
    return k < least ? 0 : k;
}

// Whether the next region can be reached from the end of the front region's last bead.
bool ends_well(const State& state, std::uint32_t c, const Bead& bead, double reach) {
    const Vec2 end = bead.points.back();
    if (state.front.next == NextPlace::above)
        return nearest_entry(state.window[1], end, reach * (state.window[0].width + state.window[1].width) / 2)
            .has_value();
    return sees_outside(state, end, SegmentIndex(as_printed(state, c, bead)));
}

// The lane from the end of the region's last bead, between its beads, to a place from which the next region is in
// reach. Of such places it takes one with as many further regions in reach as possible. If the next region is beside,
// it takes one from which a straight way leads out.
std::optional<std::vector<Vec2>> lane(const State& state, std::uint32_t c, const Bead& bead, double reach) {
    const auto curves = as_printed(state, c, bead);
    std::vector<std::vector<Vec2>> lines;
    for (const auto& curve : curves) {
        lines.push_back(curve.points);
        if (curve.closed) lines.back().push_back(curve.points.front());
    }
    const SegmentIndex index(curves);
    const bool above = state.front.next == NextPlace::above;
    const auto strips = std::span(kStrips).first(above ? kStrips.size() : 1); // a way out of the region needs room
    return strip_route(lines, curves, index, bead.points.back(), state.region().width, strips,
                       above ? static_cast<int>(climbing(state)) : 1, [&](Vec2 p, int least) {
                           return above ? rank_above(state, p, least, reach) : sees_outside(state, p, index) ? 1 : 0;
                       });
}

} // namespace

std::optional<std::vector<Vec2>> leave(State& state, std::uint32_t c, Bead& bead, const std::function<Bead()>& other) {
    if (state.front.next == NextPlace::anywhere) return std::nullopt;
    for (const double reach : reaches(state, state.window[std::min<std::size_t>(1, state.window.size() - 1)])) {
        if (ends_well(state, c, bead, reach)) return std::nullopt;
        Bead back = other();
        if (ends_well(state, c, back, reach)) {
            bead = std::move(back);
            return std::nullopt;
        }
        auto way = lane(state, c, bead, reach);
        if (!way && (way = lane(state, c, back, reach))) bead = std::move(back);
        if (way) {
            ++state.counts.lanes;
            state.counts.lane_length += length(*way);
            return way;
        }
        if (state.front.next == NextPlace::outside) break;
    }
    return std::nullopt;
}

void lay_lane(State& state, const std::vector<Vec2>& way) {
    const double z = state.region().paths.z;
    std::vector<Vec3> points(way.size());
    std::transform(way.begin(), way.end(), points.begin(), [&](Vec2 p) { return at_height(p, z); });
    extrude(state, Role::jog, std::move(points));
}

} // namespace filum::link3d
