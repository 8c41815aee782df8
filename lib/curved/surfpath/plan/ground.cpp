#include "surfpath/plan/ground.hpp"

#include "surface/curve/strip.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <optional>

namespace filum::surfpath::plan {

namespace {

// A way along the surface may be this many times as long as the straight distance. Tuned: rules::kHalfTurn cuts the
// path of field on a branched pipe five times instead of once.
constexpr double kRoundabout = 2;

double off_line(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double l2 = dot(d, d), t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
    return distance(p, a + t * d);
}

enum class Connection { straight, bent, none };

// How the surface connects two consecutive places. `way` is set to the connecting line if that is bent.
Connection connect(const Surface& s, const Place& a, const Place& b, Line& way) {
    if (surface::curve::lies_in(s, a.triangle, b.point) || distance(a.point, b.point) < rules::kSamePoint)
        return Connection::straight;
    way = surface::curve::join(s, a, b);
    if (!surface::curve::leads(s, way)) { // for example across a crease
        const double longest = kRoundabout * distance(a.point, b.point);
        way = surface::curve::through_strip(s, a, b, longest);
        if (way.size() == 0 || surface::curve::length(way) > longest) return Connection::none;
    }
    double most = 0;
    for (const Place& p : way.places) most = std::max(most, off_line(p.point, a.point, b.point));
    return most > rules::kOff ? Connection::bent : Connection::straight;
}

struct StrokeBreaks {
    std::size_t count = 0;
    double longest = 0; // mm
    Vec3 at;
};

// Splits a stroke where consecutive places are not connected by the surface.
std::vector<Stroke> split(const Surface& s, const Stroke& stroke, StrokeBreaks& breaks) {
    std::vector<Stroke> out(1);
    std::optional<Place> before;
    for (const Section& piece : stroke.sections) {
        Section now{{}, piece.hairpin};
        const auto close = [&] {
            if (now.line.size() > 1) out.back().sections.push_back(now);
            now.line.places.clear();
        };
        for (const Place& given : piece.line.places) {
            const Place p = surface::curve::settled(s, given);
            Line way;
            const Connection to = before ? connect(s, *before, p, way) : Connection::straight;
            if (to == Connection::none) {
                const double l = distance(before->point, p.point);
                if (l > breaks.longest) {
                    breaks.longest = l;
                    breaks.at = before->point;
                }
                ++breaks.count;
                close();
                if (!out.back().sections.empty()) out.emplace_back();
            }
            if (to == Connection::bent)
                now.line.places.insert(now.line.places.end(), way.places.begin() + 1, way.places.end() - 1);
            now.line.places.push_back(p);
            before = p;
        }
        close();
    }
    if (out.back().sections.empty()) out.pop_back();
    return out;
}

} // namespace

std::size_t keep_to_surface(const Surface& s, Plan& plan) {
    StrokeBreaks breaks;
    std::vector<Stroke> kept;
    for (const Stroke& stroke : plan.strokes)
        for (Stroke& part : split(s, stroke, breaks)) kept.push_back(std::move(part));
    plan.strokes = std::move(kept);
    if (breaks.count > 0)
        plan.notes.push_back(
            {NoteCode::stroke_leaves_surface, breaks.longest, breaks.count, -1, breaks.at.x, breaks.at.y, breaks.at.z});
    return breaks.count;
}

} // namespace filum::surfpath::plan
