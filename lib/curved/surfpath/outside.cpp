#include "surfpath/outside.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/fronts/source_lines.hpp"
#include "surfpath/rules/rules.hpp"

#include <optional>

namespace filum::surfpath {

namespace {

// Whether the point lies on a rim. It may be at a vertex of the rim, in a triangle without a side on it.
bool on_rim(const Surface& s, const Vec3& p) {
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        if (s.twin[h] == surface::kNone && surface::distance_to_side(s, h, p) < rules::kSamePoint) return true;
    return false;
}

// If a source line ends on a rim of `s`, extends it straight over the flange by `length` mm.
void go_on(const Surface& s, const Surface& flanged, Line line, double length, surface::Sources& to) {
    const std::size_t n = line.size();
    if (n < 2 || line.closed) return;
    const Place end{line.places[n - 2].triangle, line.places[n - 1].point};
    if (!on_rim(s, end.point)) return;
    const Line on = surface::curve::walk(flanged, end, end.point - line.places[n - 2].point, length);
    for (std::size_t i = 0; i + 1 < on.size(); ++i)
        if (distance(on[i], on[i + 1]) > rules::kSamePoint)
            to.segments.push_back({on.places[i].triangle, on[i], on[i + 1]});
}

} // namespace

bool has_rows(Algorithm a) {
    return a == Algorithm::fina || a == Algorithm::fexa || a == Algorithm::ortheo || a == Algorithm::field;
}

std::optional<Flange> flange(const surface::Sheet& sheet, const Options& o) {
    const double depth = o.turn_outside;
    if (depth == 0 || !has_rows(o.algorithm)) return {};
    if (depth < o.spacing)
        throw Error(Exit::usage, "--turn-outside " + shortest_text(depth) +
                                     " mm is less than a spacing; a turn needs the least radius and half a spacing");
    auto grown_out = surface::flanged(sheet.surface, o.spacing / 2, depth);
    Flange out;
    out.part = grown_out.part;
    out.far = std::move(grown_out.far);
    out.least = grown_out.least;
    out.least_at = grown_out.least_at;
    out.lids = std::move(grown_out.lids);
    for (const auto& field : sheet.fields) out.sheet.fields.push_back(surface::picked(field, grown_out.root));
    out.sheet.surface = std::move(grown_out.surface);
    out.sheet.name = sheet.name;
    out.sheet.algorithm = sheet.algorithm;
    out.sheet.sources = sheet.sources;
    if (o.algorithm == Algorithm::fexa) return out;
    const double longest = depth / rules::kAlong; // the way of a source that crosses the flange at a slant
    for (Line& line : fronts::source_lines(sheet.sources)) {
        Line back = line;
        surface::curve::reverse(back);
        go_on(sheet.surface, out.sheet.surface, std::move(line), longest, out.sheet.sources);
        go_on(sheet.surface, out.sheet.surface, std::move(back), longest, out.sheet.sources);
    }
    return out;
}

Options on_flange(const Flange& flange, Options options) {
    options.beyond = flange.far;
    options.part = flange.part;
    return options;
}

void thread(const Surface& s, Plan& plan) {
    for (Stroke& stroke : plan.strokes)
        for (Section& piece : stroke.sections) piece.line = surface::curve::threaded(s, piece.line);
}

Trims trims(const Plan& plan, std::uint32_t part) {
    Trims out;
    for (std::size_t k = 0; k < plan.strokes.size(); ++k) {
        double way = 0;
        std::optional<bool> before;
        for (const Section& piece : plan.strokes[k].sections)
            for (std::size_t i = 0; i + 1 < piece.line.size(); ++i) {
                const bool inside = piece.line.places[i].triangle < part;
                const double length = distance(piece.line[i], piece.line[i + 1]);
                if (before && *before != inside) out.all.push_back({k, way, piece.line[i]});
                if (!inside) out.outside += length;
                before = inside;
                way += length;
            }
    }
    return out;
}

void report_trims(const Flange& flange, double depth, Plan& plan) {
    const Trims found = trims(plan, flange.part);
    plan.facts.push_back({"", "trims", static_cast<double>(found.all.size()), ""});
    plan.facts.push_back({"", "outside", found.outside, "mm"});
    for (const auto& lid : flange.lids)
        plan.notes.push_back({lid.notch ? NoteCode::notch_covered : NoteCode::hole_covered, lid.area, 1, -1,
                              lid.middle.x, lid.middle.y, lid.middle.z});
    if (flange.least < depth)
        plan.notes.push_back(
            {NoteCode::outside_narrow, flange.least, 1, -1, flange.least_at.x, flange.least_at.y, flange.least_at.z});
}

} // namespace filum::surfpath
