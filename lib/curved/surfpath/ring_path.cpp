#include "surfpath/ring_path.hpp"

#include "base/error.hpp"
#include "surface/curve/ease.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/lanes/spiral.hpp"
#include "surfpath/rings/rings.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace filum::surfpath {

namespace {

constexpr double kPathStep = 0.1; // least radii between points of the path

// The line eased and resampled in equal steps, so that noise from crossed edges does not count as curvature.
Line gentle(const Surface& s, const Line& line, double radius, double spacing) {
    const auto eased = surface::curve::ease(
        s, line, {.radius = rules::kRounded * radius, .corridor = rules::kMostGive * spacing, .step = 0.05 * radius});
    Line out = surface::curve::resampled(eased.line, kPathStep * radius);
    for (Place& p : out.places) p = surface::curve::settled(s, p);
    return surface::curve::threaded(s, out);
}

// Adds a note if there are more strokes than components with rings, at the start of the shortest stroke.
void note_unjoined(const Surface& s, const rings::Rings& made, Plan& plan) {
    std::set<std::uint32_t> components;
    for (const Line& line : made.lines) components.insert(s.component[line.places[0].triangle]);
    const std::size_t apart = plan.strokes.size() - components.size();
    if (apart == 0) return;
    const auto length = [](const Stroke& stroke) { return surface::curve::length(stroke.sections[0].line); };
    const auto shortest = std::min_element(plan.strokes.begin(), plan.strokes.end(),
                                           [&](const auto& a, const auto& b) { return length(a) < length(b); });
    const Vec3 at = shortest->sections[0].line[0];
    plan.notes.push_back({NoteCode::ring_unjoined, static_cast<double>(apart), apart, -1, at.x, at.y, at.z});
}

} // namespace

Plan ring_path(const surface::Sheet& sheet, const Options& given, int by) {
    Plan out;
    Options o = given;
    o.least_radius = std::max(o.least_radius, o.spacing / 2);
    const Surface& s = sheet.surface;
    rings::Rings made = rings::rings(sheet, {o.spacing, o.least_radius, by == 1}, out.facts, out.notes);
    const lanes::Lanes lanes(s, made.lines, o.spacing);
    lanes::LinkedLanes linked(lanes);
    std::uint32_t start = surface::kNone;
    for (std::uint32_t l = 0; l < lanes.size(); ++l)
        if (made.level[l] == 0 && (start == surface::kNone || lanes.length(l) > lanes.length(start))) start = l;
    if (start != surface::kNone) {
        const lanes::Ladder ladder =
            lanes::spiral_ladder(lanes, start, rules::shift_length(o.least_radius, by * o.spacing));
        if (ladder.lanes() >= static_cast<std::size_t>(by) + 1) lanes::shift(linked, lanes, ladder, by, o.least_radius);
        out.facts.push_back({"", "seam-lanes", static_cast<double>(ladder.lanes()), ""});
        if (ladder.lanes()) out.facts.push_back({"", "seam-length", shortest(lanes, ladder), "mm"});
    }
    lanes::exchange_lanes(linked, lanes, o.least_radius);
    for (auto& path : linked.curves())
        out.strokes.push_back({{{gentle(s, path.line, o.least_radius, o.spacing), false}}});
    if (out.strokes.empty())
        throw Error(Exit::failure, "cannot lay rings: none is closed; make other triangles by geodesic --remesh");
    note_unjoined(s, made, out);
    return out;
}

} // namespace filum::surfpath
