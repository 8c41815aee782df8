#include "metrics/planar/path_statistics.hpp"

namespace filum::metrics::planar {

namespace {

using toolpath::Role;

constexpr double kStop = 0.05; // mm
constexpr double kHop = 0.5;   // mm
constexpr double kStill = 1e-9;

std::size_t index(Role r) { return static_cast<std::size_t>(r); }

// Ends a gap before an extruding move at layer height `height`.
void close_gap(PathStatistics& c, double height) {
    const double aside = geom::distance(c.gap_start.xy(), c.at.xy()), up = std::abs(c.at.z - c.gap_start.z);
    const bool stop = (c.gap_held ? c.gap_xy : c.gap_way) > kStop || c.gap_taken;
    const bool held = c.gap_held && !c.gap_taken && aside <= kHop;
    c.stops += stop ? 1 : 0;
    c.longest_gap = std::max(c.longest_gap, c.gap_xy);
    if ((stop && !held) || up > 2.01 * height) {
        ++c.breaks;
        if (aside <= kHop && up <= 2.01 * height)
            ++c.hops;
        else
            ++(up < height / 2 ? c.travels : c.climbs);
    }
    c.in_gap = false;
}

void enter_gap(PathStatistics& c, toolpath::Retraction retraction) {
    if (!c.in_gap) {
        c.in_gap = c.gap_held = true;
        c.gap_taken = false;
        c.gap_start = c.at;
        c.gap_xy = c.gap_way = 0;
    }
    c.gap_taken = c.gap_taken || retraction == toolpath::Retraction::taken;
    c.gap_held = c.gap_held && retraction == toolpath::Retraction::none;
}

void move(PathStatistics& c, geom::Vec3 to, bool extruding, toolpath::Retraction retraction) {
    if (!extruding && c.begun) {
        enter_gap(c, retraction);
        c.gap_xy += geom::distance(c.at.xy(), to.xy());
        c.gap_way += geom::distance(c.at, to);
    }
    c.at = to;
}

void extend(PathStatistics& c, geom::Vec3 p) {
    c.lo = {std::min(c.lo.x, p.x), std::min(c.lo.y, p.y), std::min(c.lo.z, p.z)};
    c.hi = {std::max(c.hi.x, p.x), std::max(c.hi.y, p.y), std::max(c.hi.z, p.z)};
}

} // namespace

void follow(PathStatistics& c, const toolpath::Span& span) {
    const bool extruding = toolpath::extrudes(span.role);
    if (c.begun && !(span.points.front() == c.at)) {
        ++c.jumps;
        c.length[index(Role::travel)] += geom::distance(c.at, span.points.front());
        move(c, span.points.front(), false, toolpath::Retraction::by_machine);
    }
    c.at = span.points.front();
    if (!extruding && c.begun && span.retraction == toolpath::Retraction::taken) enter_gap(c, span.retraction);
    bool fresh = true; // no move of this span yet
    for (std::size_t i = 0; i + 1 < span.points.size(); ++i) {
        const double d = geom::distance(span.points[i], span.points[i + 1]);
        if (d <= kStill) continue;
        c.length[index(span.role)] += d;
        if (extruding) {
            const bool gap = c.in_gap;
            if (gap) close_gap(c, span.height_at(i));
            if (fresh && !toolpath::fills(span.role) && (gap || c.last != span.role || !c.begun))
                ++c.joins[index(span.role)];
            if (fresh && !gap && c.begun && toolpath::fills(c.last) && toolpath::fills(span.role) &&
                std::abs(span.points[i].z - span.points[i + 1].z) > 0.01 * span.height_at(i))
                ++c.bare_climbs;
            c.volume[index(span.role)] += toolpath::volume(span, i);
            c.begun = true;
            c.last = span.role;
            ++c.extruding_moves;
            extend(c, span.points[i]);
            extend(c, span.points[i + 1]);
        } else if (fresh) {
            ++c.joins[index(span.role)];
        }
        fresh = false;
        move(c, span.points[i + 1], extruding, span.retraction);
    }
}

} // namespace filum::metrics::planar
