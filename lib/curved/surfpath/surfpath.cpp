#include "surfpath/surfpath.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "surface/curve/turns.hpp"
#include "surfpath/components.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/field_hybrid.hpp"
#include "surfpath/fina.hpp"
#include "surfpath/geo_contour.hpp"
#include "surfpath/geo_fiso.hpp"
#include "surfpath/geo_spiral.hpp"
#include "surfpath/ortheo.hpp"
#include "surfpath/plan/canonical.hpp"
#include "surfpath/plan/coarse.hpp"
#include "surfpath/plan/cost.hpp"
#include "surfpath/plan/coverage.hpp"
#include "surfpath/plan/declare.hpp"
#include "surfpath/plan/ground.hpp"
#include "surfpath/plan/refined.hpp"
#include "surfpath/plan/round_path.hpp"
#include "surfpath/plan/widths.hpp"
#include "surfpath/rules/rules.hpp"
#include "surfpath/slits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace filum::surfpath {

namespace {

Plan lines(const surface::Sheet& sheet, const Options& options) {
    const bool by_rows = options.algorithm == Algorithm::fina || options.algorithm == Algorithm::fexa;
    if (by_rows && options.turns == RowTurns::none)
        throw Error(Exit::usage,
                    "cannot end rows of fina and fexa at the rims; use --turns hairpin or wide, or ortheo");
    switch (options.algorithm) {
    case Algorithm::fina:
        return fina(sheet, options);
    case Algorithm::fexa:
        return fexa(sheet, options);
    case Algorithm::ortheo:
        return ortheo(sheet, options);
    case Algorithm::geo_fiso:
        return geo_fiso(sheet, options);
    case Algorithm::geo_contour:
        return geo_contour(sheet, options);
    case Algorithm::geo_spiral:
        return geo_spiral(sheet, options);
    case Algorithm::field:
        return follow(sheet, options);
    case Algorithm::hybrid:
        return hybrid(sheet, options);
    }
    throw std::logic_error("no such algorithm");
}

// Whether the algorithm's lines start beside rims and sources.
bool has_rings(const Options& o) {
    return o.algorithm == Algorithm::geo_fiso || o.algorithm == Algorithm::geo_contour ||
           o.algorithm == Algorithm::hybrid || (o.algorithm == Algorithm::field && o.follow.rings > 0);
}

// The fields of the sheet that `field` may follow.
std::vector<surface::Field> directions(const surface::Sheet& sheet) {
    std::vector<surface::Field> out;
    for (const auto& f : sheet.fields)
        if (f.name.starts_with("stress.") || f.name == kDirection) out.push_back(f);
    return out;
}

bool by_field(const Options& o) { return o.algorithm == Algorithm::field || o.algorithm == Algorithm::hybrid; }

// mm: how long sides of triangles may be for lines of the options. Two lines in one triangle are parallel. So triangles
// of level lines are no larger than neighbours are apart. Stripes need a vertex on either side of each line; those that
// keep the angle need another one between them, as the error of their angle is proportional to the side.
double longest_side(const Options& o) {
    return !by_field(o) ? rules::kBeside * o.spacing : keeps_angle(o) ? o.spacing / 2 : o.spacing;
}

Plan with_round_turns(const surface::Sheet& sheet, const Options& options) {
    Plan out = lines(sheet, options);
    plan::round_kinks(sheet.surface, out, options.spacing);
    if (by_field(options) && options.width_change > 0) // lines of one width have no room to move
        plan::round_bends(sheet.surface, out, {options.spacing, options.least_radius, 1 - options.width_change});
    return out;
}

// The plan on a sheet of small triangles; for hybrid, of those along each of its sources the one that costs least.
Plan on_small_triangles(const surface::Sheet& sheet, const Options& options) {
    if (options.algorithm != Algorithm::hybrid) return with_round_turns(sheet, options);
    const auto sources = hybrid_sources(sheet.surface, options);
    Plan out;
    double least = std::numeric_limits<double>::infinity();
    for (const Options& o : sources) {
        Plan now = with_round_turns(sheet, o);
        if (sources.size() == 1) return now;
        const double cost = plan::cost(sheet.surface, now, {o.spacing, o.least_radius, o.cut_length, o.width_change});
        if (out.strokes.empty() || cost < least) {
            out = std::move(now);
            least = cost;
        }
    }
    return out;
}

// The plan on the sheet as it is.
Plan as_given(const surface::Sheet& sheet, const Options& options) {
    plan::RefinedSheet small = plan::refined(sheet, longest_side(options));
    if (by_field(options)) small.sheet.fields = plan::on_refined(sheet, directions(sheet), small);
    Options on_small = options;
    on_small.beyond.clear();
    if (!options.beyond.empty())
        for (const std::uint32_t t : small.parent) on_small.beyond.push_back(options.beyond[t]);
    Notes opened;
    if (has_rings(options)) {
        const surface::Sources slit = slits(small.sheet, opened);
        auto& to = small.sheet.sources.segments;
        to.insert(to.end(), slit.segments.begin(), slit.segments.end());
    }
    Plan out = on_small_triangles(small.sheet, on_small);
    out.notes.insert(out.notes.end(), opened.begin(), opened.end());
    plan::to_parents(out, small);
    return out;
}

// The plan on larger triangles, if those of the sheet are much finer than lines of field need.
Plan on_needed_triangles(const surface::Sheet& sheet, const Options& options) {
    if (!options.coarsen || !options.beyond.empty() || !sheet.sources.empty()) return as_given(sheet, options);
    const auto side = plan::coarse_side(sheet.surface, longest_side(options));
    if (!side) return as_given(sheet, options);
    plan::RefinedSheet ordered = plan::refined(sheet, std::numeric_limits<double>::infinity());
    ordered.sheet.fields = plan::on_refined(sheet, directions(sheet), ordered);
    const surface::curve::Locator locator(ordered.sheet.surface);
    const surface::Sheet coarse = plan::coarser(ordered.sheet, locator, *side, rules::kOff);
    if (coarse.surface.triangles.size() >= sheet.surface.triangles.size()) return as_given(sheet, options);
    Plan out = as_given(coarse, options);
    plan::to_given(out, coarse.surface, locator);
    plan::to_parents(out, ordered);
    return out;
}

// The plan on a sheet without what rounding and the choice of axes add, moved to the given one. Lines of field need
// this: on symmetric surfaces many places and turns are equally good, and the last bit would choose.
Plan on_canonical(const surface::Sheet& given, const Options& options) {
    const auto& to = options.follow.reference;
    const bool by_angle = directions_followed(given, options).angle > 0;
    const auto canonical = plan::canonical(given, options.spacing, by_angle ? to : Vec3{});
    Options o = options;
    if (by_angle) o.follow.reference = canonical.direction;
    for (Vec3& p : o.births_apart) p = canonical.frame.into(p - canonical.frame.centre);
    Plan out = on_needed_triangles(canonical.sheet, o);
    plan::from_canonical(out, canonical, given);
    return out;
}

Plan of_component(const surface::Sheet& sheet, const Options& options) {
    Plan out = by_field(options) ? on_canonical(sheet, options) : as_given(sheet, options);
    plan::keep_to_surface(sheet.surface, out);
    return out;
}

std::string text(const Vec3& p) { return fixed_text(p.x, 2) + "," + fixed_text(p.y, 2) + "," + fixed_text(p.z, 2); }

} // namespace

Plan plan_paths(const surface::Sheet& sheet, const Options& options) {
    return sheet.surface.components > 1 ? each_component(sheet, options, of_component) : of_component(sheet, options);
}

void leave_out_short(Plan& plan, double least) {
    Note note{.code = NoteCode::line_too_short, .count = 0};
    std::erase_if(plan.strokes, [&](const Stroke& stroke) {
        double length = 0;
        for (const Section& section : stroke.sections) length += surface::curve::length(section.line);
        if (!(length < least)) return false;
        const Vec3& at = stroke.sections.front().line[0];
        if (length > note.amount / std::max(1.0, static_cast<double>(note.count))) {
            note.x = at.x;
            note.y = at.y;
            note.z = at.z;
        }
        note.amount += length;
        ++note.count;
        return true;
    });
    if (note.count == 0) return;
    plan.notes.push_back(note);
    for (Fact& fact : plan.facts)
        if (fact.name == "cuts") fact.value = plan.strokes.empty() ? 0 : static_cast<double>(plan.strokes.size() - 1);
}

void finish(const Surface& surface, Plan& plan, const Options& o) {
    leave_out_short(plan, o.min_length);
    // However long the stretch over which radii are measured, the excess lies within that on either side.
    const double beside = std::max(surface::curve::turn_reach(o.least_radius, o.spacing), o.spacing / 2);
    const plan::TightTurns tight = plan::mark_tight_turns(surface, plan, {o.least_radius, o.spacing, beside, o.offset});
    if (o.strict && tight.length > o.max_tight * tight.fibre)
        throw Error(Exit::failure, "cannot keep turns to " + shortest_text(o.least_radius) +
                                       " mm: " + fixed_text(tight.length, 1) + " mm of " + fixed_text(tight.fibre, 0) +
                                       " mm turn tighter, more than --max-tight allows, down to " +
                                       fixed_text(tight.least, 2) + " mm at " + text(tight.at) +
                                       "; lower --min-radius, raise --max-tight, or leave out --strict");
    plan.facts.push_back({"", "tight-turns", static_cast<double>(tight.count), ""});
    plan.facts.push_back({"", "tight-length", tight.length, "mm"});
    plan.facts.push_back({"", "kink-length", tight.kinks, "mm"});
    if (std::isfinite(tight.least)) plan.facts.push_back({"", "least-radius", tight.least, "mm"});
    if (tight.count > 0)
        plan.notes.push_back(
            {NoteCode::bend_too_tight, tight.length, tight.count, -1, tight.at.x, tight.at.y, tight.at.z});
    if (o.width_change > 0) plan::fit_widths(surface, plan, {o.spacing, o.width_change});
    plan::report_coverage(surface, plan, o.spacing, o.part);
}

} // namespace filum::surfpath
