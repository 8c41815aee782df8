#include "surfpath/plan/declare.hpp"

#include "geom/polyline.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <limits>

namespace filum::surfpath::plan {

namespace {

// The stroke as one line without repeated places.
Line joined(const Stroke& stroke) {
    Line out;
    for (const Section& piece : stroke.sections) surface::curve::append(out, piece.line);
    return out;
}

struct Interval {
    double from, to;
};

// The turns with `by` mm on both sides; those that then overlap are merged.
std::vector<Interval> widened(const std::vector<surface::curve::TightTurn>& turns, double by, double length) {
    std::vector<Interval> out;
    for (const auto& t : turns) {
        const Interval r{std::max(0.0, t.from - by), std::min(length, t.to + by)};
        if (out.empty() || r.from > out.back().to)
            out.push_back(r);
        else
            out.back().to = r.to;
    }
    return out;
}

// The section of the line between two arc lengths. Its end points stay on the path; each gets the triangle in which it
// lies or which is nearest, since a segment may lead from triangle to triangle outside both.
Section section(const Surface& s, const Line& line, std::span<const double> arcs, Interval r, bool hairpin) {
    Section out{surface::curve::part(line, arcs, r.from, r.to), hairpin};
    for (Place* p : {&out.line.places.front(), &out.line.places.back()})
        p->triangle = surface::curve::settled(s, *p).triangle;
    return out;
}

} // namespace

TightTurns mark_tight_turns(const Surface& s, Plan& plan, const TurnLimits& o) {
    namespace curve = surface::curve;
    TightTurns out;
    out.least = std::numeric_limits<double>::infinity();
    const double kink = curve::kKinkRadius * o.spacing;
    const double reach = curve::turn_reach(o.radius, o.spacing), near = curve::turn_reach(kink, o.spacing);
    const auto vertex_normals = surface::curve::vertex_normals(s);
    double tightest = o.radius;
    for (Stroke& stroke : plan.strokes) {
        const Line line = joined(stroke);
        if (line.size() < 2) continue;
        std::vector<Vec3> points, normals;
        for (const Place& p : line.places) {
            normals.push_back(surface::curve::normal_at(s, vertex_normals, p));
            points.push_back(p.point + o.offset * normals.back());
        }
        const std::vector<double> arcs = geom::arc_lengths(points);
        out.fibre += arcs.back();
        out.least = std::min(out.least, curve::least_radius(points, normals, near));
        out.kinks += curve::length(curve::tight_turns(points, normals, kink, near));
        for (const auto& t : curve::tight_turns(points, normals, o.radius, reach)) {
            ++out.count;
            out.length += t.to - t.from;
            if (t.radius < tightest) {
                tightest = t.radius;
                out.at = curve::at(line, arcs, t.at).point;
            }
        }
        const auto marked = curve::tight_turns(points, normals, rules::kSurely * o.radius, reach);
        stroke.sections.clear();
        double done = 0;
        for (const Interval& r : widened(marked, o.beside, arcs.back())) {
            if (r.from > done) stroke.sections.push_back(section(s, line, arcs, {done, r.from}, false));
            stroke.sections.push_back(section(s, line, arcs, r, true));
            done = r.to;
        }
        if (done < arcs.back()) stroke.sections.push_back(section(s, line, arcs, {done, arcs.back()}, false));
    }
    return out;
}

} // namespace filum::surfpath::plan
