#include "machine/feed.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace filum::machine {

namespace {

double role_feed(const Feeds& feeds, toolpath::Role role) {
    switch (role) {
    case toolpath::Role::lift:
        return feeds.lift;
    case toolpath::Role::jog:
        return feeds.jog;
    case toolpath::Role::connector:
        return feeds.connector;
    case toolpath::Role::bead:
    case toolpath::Role::hairpin:
    case toolpath::Role::travel:
        break;
    }
    return feeds.bead;
}

} // namespace

ExtrudingMove extruding_move(const toolpath::Span& span, std::size_t i) {
    const geom::Vec3 a = span.points[i], b = span.points[i + 1];
    return {span.role,    span.layer,   geom::distance(a, b), std::abs(b.z - a.z), toolpath::volume(span, i),
            span.feature, span.over_air};
}

namespace {

bool fills_area(toolpath::Feature f) {
    using toolpath::Feature;
    return f == Feature::infill || f == Feature::solid || f == Feature::bottom || f == Feature::top;
}

// The feed of a move of the first layer that would have the feed `v` elsewhere.
double first_layer_feed(const Profile& p, const ExtrudingMove& move, double v) {
    const Feeds& f = p.feeds;
    const bool fills = toolpath::fills(move.role);
    if (f.first_layer_share > 0 && fills) return std::min(f.first_layer_share * v, p.motion.max_speed);
    const double own = f.first_layer_infill > 0 && fills_area(move.feature) ? f.first_layer_infill : f.first_layer;
    return f.first_layer_exact && fills ? own : std::min(v, own);
}

// The feed without the pace of its layer.
double full_feed(const Profile& p, const ExtrudingMove& move) {
    double v = role_feed(p.feeds, move.role);
    const double own = p.feeds.feature[static_cast<std::size_t>(move.feature)];
    if (toolpath::fills(move.role) && own > 0) v = own;
    if (toolpath::fills(move.role) && move.over_air > 0)
        v = std::min(p.overhang.feed(v, move.over_air / 100.0), p.motion.max_speed);
    if (move.layer == 0) v = first_layer_feed(p, move, v);
    if (!(move.length > 0)) return v;
    const double section = move.volume / move.length * p.extrusion.flow;
    const double most = std::min(section > 0 ? p.limits.flow / section : v,
                                 move.rise > 0 ? p.motion.max_speed_z * move.length / move.rise : v);
    if (most >= v) return v;
    return most >= 1 ? std::floor(most) : most;
}

// The share of its feeds that a layer keeps.  Feeds at their least do not become lower, so the others keep less:
// least = sum(length / (share * full)) over those above their least + sum(length / least) over the rest.
double share_kept(const std::map<LayerTimes::Feed, double>& lengths, double least) {
    std::vector<std::pair<double, LayerTimes::Feed>> by_room; // share of the full feed at which the least is reached
    double free = 0, held = 0;                                // s at full feeds; s of beads at their least
    for (const auto& [feed, length] : lengths) {
        free += length / feed.full;
        by_room.emplace_back(feed.least / feed.full, feed);
    }
    if (!(free > 0) || free >= least) return 1;
    std::ranges::sort(by_room, std::greater<>());
    for (const auto& [room, feed] : by_room) {
        const double share = held < least ? free / (least - held) : 0;
        if (share >= room && share > 0) return share;
        free -= lengths.at(feed) / feed.full;
        held += lengths.at(feed) / feed.least;
    }
    return 0; // all beads are at their least feeds
}

// Highest number of a layer: a list of times has an entry for each number.
constexpr std::uint32_t kHighestLayer = 4'000'000;

} // namespace

double bead_feed(const Profile& p, const ExtrudingMove& move) {
    const double v = full_feed(p, move);
    if (move.layer >= p.pace.size()) return v;
    return std::max(v * p.pace[move.layer], std::min(v, p.limits.least_feed));
}

void LayerTimes::add(const Profile& profile, const toolpath::Span& span) {
    if (!toolpath::extrudes(span.role) || profile.fibre.lays(span.tool)) return;
    if (span.layer > kHighestLayer)
        throw Error(Exit::bad_input, "cannot time layer " + std::to_string(span.layer) +
                                         ": layers are numbered from 0 to " + std::to_string(kHighestLayer) +
                                         " at most; number them without gaps");
    if (span.layer >= layers.size()) layers.resize(span.layer + 1);
    const Profile& own = of_tool(profile, span.tool);
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const ExtrudingMove move = extruding_move(span, i);
        const double full = full_feed(own, move);
        if (move.length > 0) layers[span.layer][{full, std::min(full, own.limits.least_feed)}] += move.length;
    }
}

std::vector<double> pace(const LayerTimes& times, double least) {
    std::vector<double> out;
    for (const auto& lengths : times.layers) out.push_back(share_kept(lengths, least));
    return out;
}

double fibre_feed(const Profile& p, const ExtrudingMove& move, double feed) {
    if (!(move.rise > 0)) return feed;
    return std::min(feed, p.motion.max_speed_z * move.length / move.rise);
}

} // namespace filum::machine
