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

double bead_feed(const Profile& p, const toolpath::Span& span, std::size_t i) {
    double v = role_feed(p.feeds, span.role);
    if (span.layer == 0) v = std::min(v, p.feeds.first_layer);
    const double length = geom::distance(span.points[i], span.points[i + 1]);
    if (!(length > 0)) return v;
    const double section = toolpath::volume(span, i) / length * p.extrusion.flow;
    const double rise = std::abs(span.points[i + 1].z - span.points[i].z);
    const double most =
        std::min(section > 0 ? p.limits.flow / section : v, rise > 0 ? p.motion.max_speed_z * length / rise : v);
    if (most >= v) return v;
    return most >= 1 ? std::floor(most) : most;
}

double fibre_feed(const Profile& p, const toolpath::Span& span, std::size_t i, double feed) {
    const double rise = std::abs(span.points[i + 1].z - span.points[i].z);
    if (!(rise > 0)) return feed;
    return std::min(feed, p.motion.max_speed_z * geom::distance(span.points[i], span.points[i + 1]) / rise);
}

} // namespace filum::machine
