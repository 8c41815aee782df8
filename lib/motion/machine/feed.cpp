#include "machine/feed.hpp"

#include <algorithm>
#include <cmath>

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

Laid laid(const toolpath::Span& span, std::size_t i) {
    const geom::Vec3 a = span.points[i], b = span.points[i + 1];
    return {span.role, span.layer, geom::distance(a, b), std::abs(b.z - a.z), toolpath::volume(span, i), span.feature};
}

double bead_feed(const Profile& p, const Laid& move) {
    double v = role_feed(p.feeds, move.role);
    const double own = p.feeds.feature[static_cast<std::size_t>(move.feature)];
    if (toolpath::fills(move.role) && own > 0) v = own;
    if (move.layer == 0) v = std::min(v, p.feeds.first_layer);
    if (move.layer < p.pace.size()) v *= p.pace[move.layer];
    if (!(move.length > 0)) return v;
    const double section = move.volume / move.length * p.extrusion.flow;
    const double most = std::min(section > 0 ? p.limits.flow / section : v,
                                 move.rise > 0 ? p.motion.max_speed_z * move.length / move.rise : v);
    if (most >= v) return v;
    return most >= 1 ? std::floor(most) : most;
}

void LayerTimes::add(const Profile& profile, const toolpath::Span& span) {
    if (!toolpath::extrudes(span.role) || profile.fibre.lays(span.tool)) return;
    if (span.layer >= seconds.size()) seconds.resize(span.layer + 1, 0);
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const Laid move = laid(span, i);
        if (move.length > 0) seconds[span.layer] += move.length / bead_feed(of_tool(profile, span.tool), move);
    }
}

std::vector<double> pace(const LayerTimes& times, double least) {
    std::vector<double> out;
    for (const double seconds : times.seconds) out.push_back(seconds > 0 ? std::min(1.0, seconds / least) : 1.0);
    return out;
}

double fibre_feed(const Profile& p, const Laid& move, double feed) {
    if (!(move.rise > 0)) return feed;
    return std::min(feed, p.motion.max_speed_z * move.length / move.rise);
}

} // namespace filum::machine
