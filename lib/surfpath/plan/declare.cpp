#include "surfpath/plan/declare.hpp"

#include "geom/polyline.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <limits>

namespace filum::surfpath::plan {

namespace {

constexpr double kSurely = 1.02; // least radii: up to here turns are declared, so that none of just that radius is not

// The stroke as one line, without places that stand twice.
Line joined(const Stroke& stroke) {
    Line out;
    for (const Piece& piece : stroke.pieces) surface::curve::append(out, piece.line);
    return out;
}

struct Range {
    double from, to;
};

// With room on both sides; what then meets is one.
std::vector<Range> widened(const std::vector<surface::curve::TightTurn>& turns, double by, double length) {
    std::vector<Range> out;
    for (const auto& t : turns) {
        const Range r{std::max(0.0, t.from - by), std::min(length, t.to + by)};
        if (out.empty() || r.from > out.back().to)
            out.push_back(r);
        else
            out.back().to = r.to;
    }
    return out;
}

// The piece between two ways.  Its ends name the triangles that they lie in, or next to: where a stretch leads from one
// triangle to another, its middle belongs to neither.  The points stay where they are, on the path.
Piece piece(const Surface& s, const Line& line, std::span<const double> ways, Range r, bool hairpin) {
    Piece out{surface::curve::part(line, ways, r.from, r.to), hairpin};
    for (Place* p : {&out.line.places.front(), &out.line.places.back()})
        p->triangle = surface::curve::settled(s, *p).triangle;
    return out;
}

} // namespace

Tight declare(const Surface& s, Plan& plan, double radius, double beside, double offset) {
    Tight out{0, 0, 0, std::numeric_limits<double>::infinity(), {}};
    const auto vertex_normals = surface::curve::vertex_normals(s);
    double tightest = radius;
    for (Stroke& stroke : plan.strokes) {
        const Line line = joined(stroke);
        if (line.size() < 2) continue;
        std::vector<Vec3> points, normals;
        for (const Place& p : line.places) {
            normals.push_back(surface::curve::normal_at(s, vertex_normals, p));
            points.push_back(p.point + offset * normals.back());
        }
        const std::vector<double> ways = geom::arc_lengths(points);
        out.least = std::min(out.least, surface::curve::least_radius(points, normals));
        const auto turns = surface::curve::tight_turns(points, normals, kSurely * radius);
        for (const auto& t : turns) {
            if (!(t.radius < radius)) continue;
            ++out.count;
            out.length += t.to - t.from;
            if (t.radius < tightest) {
                tightest = t.radius;
                out.at = surface::curve::at(line, ways, t.at).point;
            }
        }
        stroke.pieces.clear();
        double done = 0;
        for (const Range& r : widened(turns, beside, ways.back())) {
            if (r.from > done) stroke.pieces.push_back(piece(s, line, ways, {done, r.from}, false));
            stroke.pieces.push_back(piece(s, line, ways, r, true));
            out.declared += r.to - r.from;
            done = r.to;
        }
        if (done < ways.back()) stroke.pieces.push_back(piece(s, line, ways, {done, ways.back()}, false));
    }
    return out;
}

} // namespace filum::surfpath::plan
