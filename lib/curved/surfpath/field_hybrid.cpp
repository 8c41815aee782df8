#include "surfpath/field_hybrid.hpp"

#include "surface/curve/ease.hpp"
#include "surfpath/field/rings.hpp"
#include "surfpath/field/stripes.hpp"
#include "surfpath/plan/cost.hpp"
#include "surfpath/plan/nearest_order.hpp"
#include "surfpath/plan/round_path.hpp"
#include "surfpath/plan/turns.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/loops.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

constexpr double kAcross = 10; // spacings: longest way from row to row across other lines
// Least radii: radius to which lines are eased. Tuned: rules::kRounded leaves a tenth of a percent more of the path
// tighter than the least radius.
constexpr double kEasedTo = 1.15;

// Share of the change of widths that distances of lines may use. Near births and turns lines are nearer or farther than
// that, and beads need the rest there.
constexpr double kBreathing = 0.5;

// Every line becomes a stroke of its own.
std::vector<Stroke> separate_strokes(std::vector<Line> lines) {
    std::vector<plan::EndPoints> ends;
    ends.reserve(lines.size());
    for (const Line& l : lines) ends.push_back({l[0], l.closed ? l[0] : l[l.size() - 1]});
    std::vector<Stroke> out;
    for (const plan::Visit& visit : plan::nearest_order(ends)) {
        if (visit.reversed) surface::curve::reverse(lines[visit.row]);
        out.push_back({{{std::move(lines[visit.row]), false}}});
    }
    return out;
}

void report(const Surface& s, const field::PrescribedDirections& prescribed, const field::Directions& d, Plan& out) {
    out.facts.push_back({"", "tightest-bend", d.tightest, "1/mm"});
    const auto note = [&](NoteCode code, double amount, const geom::Vec3& at) {
        out.notes.push_back({code, amount, 1, -1, at.x, at.y, at.z});
    };
    if (d.tight > 0) note(NoteCode::field_too_tight, d.tight, d.tight_at);
    if (d.given_up > rules::kNegligible * surface::area(s)) note(NoteCode::field_given_up, d.given_up, d.tight_at);
    if (prescribed.unknown > 0) note(NoteCode::direction_unknown, prescribed.unknown, prescribed.unknown_at);
    if (prescribed.upright > 0) {
        out.facts.push_back({"", "upright", prescribed.upright, "mm2"});
        note(NoteCode::direction_unknown, prescribed.upright, prescribed.upright_at);
    }
}

// Eases all lines to a radius, moving them at most rules::kGive spacings.
void ease(const Surface& s, std::vector<Line>& lines, double radius, double spacing) {
    for (Line& l : lines)
        l = surface::curve::ease(s, l, {.radius = kEasedTo * radius, .corridor = rules::kGive * spacing}).line;
}

// The lines that the options ask for, and where they are born.
struct TracedLines {
    std::vector<Line> lines;
    std::vector<geom::Vec3> births;
};

TracedLines traced(const surface::Sheet& sheet, const Options& o, const surface::directions::Cells& cells,
                   const field::Directions& directions) {
    if (o.whole_rings) return {field::whole_rings(sheet, o.spacing), {}};
    const Surface& s = sheet.surface;
    field::StripeOptions striping{o.spacing, o.shift, keeps_angle(o) ? field::kKeepAngle : 1};
    striping.apart = o.births_apart;
    // Rings are a spacing apart as they are; where they meet, no frequency avoids births.
    striping.change = o.follow.rings > 0 ? 0 : kBreathing * o.width_change;
    std::vector<field::Complex> like;
    if (o.follow.only(&field::DirectionMix::rings)) {
        like = field::phase(field::ring_field(sheet, cells), directions.along, o.spacing);
        striping.like = like;
    }
    const auto stripes = field::stripes(s, cells, directions.along, striping);
    return {field::lines(s, stripes), field::births(s, stripes)};
}

// mm: radii of spirals and of shifts between rows.
struct RowRadii {
    double gentle, eased;
};

// The lines as one path, with turns as `o.turns` says; `usual` means wide ones.
Plan turned(const Surface& s, const std::vector<Line>& lines, const Options& o, const RowRadii& radii) {
    std::vector<rows::UnclippedLine> raw;
    raw.reserve(lines.size());
    for (const Line& l : lines) raw.push_back({l, o.spacing * static_cast<double>(raw.size())});
    rows::leave_out(raw, o.beyond);
    rows::TurnOptions turns = rows::turn_options(o.spacing, o.least_radius, o.turns == RowTurns::hairpin);
    turns.across = kAcross * o.spacing;
    turns.along = o.cut_length;
    turns.staggered = o.beyond.empty();
    turns.tight = turns.tight || o.algorithm == Algorithm::hybrid;
    rows::Rows found = rows::rows(s, raw,
                                  {o.spacing / 2, o.spacing / 2, radii.gentle, rules::kGive * o.spacing,
                                   static_cast<unsigned>(o.rim_beads), o.rim_bead_width * o.spacing});
    const auto joined = rows::join_loops(
        s, found, {o.spacing, radii.gentle, radii.eased, o.cut_length, turns.tight, 1 - o.width_change});
    Plan out = rows::boustrophedon(s, found, turns);
    rows::report_crossings(joined.crossed, o.spacing, out.notes);
    out.facts.push_back({"", "loops-joined", static_cast<double>(joined.crossed.size() + joined.exchanged), ""});
    return out;
}

// Whether wide turns and hairpins are both tried: turns lie on the part, and may be tight.
bool chooses_turns(const Options& o) {
    return o.algorithm == Algorithm::field && o.turns == RowTurns::usual && o.beyond.empty() && !o.strict;
}

// The lines as one path, with the turns that cost least; ties: wide ones.
Plan cheapest(const Surface& s, const std::vector<Line>& lines, const Options& o, const RowRadii& radii) {
    Plan wide = turned(s, lines, o, radii);
    if (!chooses_turns(o)) return wide;
    Options tight = o;
    tight.turns = RowTurns::hairpin;
    Plan hairpins = turned(s, lines, tight, radii);
    const auto cost = [&](Plan plan) {
        plan::round_kinks(s, plan, o.spacing);
        return plan::cost(s, std::move(plan), {o.spacing, o.least_radius, o.cut_length, o.width_change});
    };
    return cost(hairpins) < cost(wide) ? hairpins : wide;
}

} // namespace

std::vector<Options> hybrid_sources(const Surface& s, const Options& options) {
    std::vector<Options> out(3, options);
    out[0].follow = out[1].follow = {.rings = 1};
    out[1].whole_rings = true;
    out[2].follow = {.rim = 1};
    if (!(options.width_change > 0) || s.rims.empty()) out.resize(1);
    return out;
}

field::DirectionMix directions_followed(const surface::Sheet& sheet, const Options& options) {
    field::DirectionMix out = options.follow;
    if (!out.only(nullptr)) return out;
    if (options.algorithm == Algorithm::hybrid) return {.rings = 1};
    const bool stressed = std::any_of(sheet.fields.begin(), sheet.fields.end(), [](const surface::Field& f) {
        return f.name.starts_with("stress.") && f.name.ends_with(".d1");
    });
    const bool has_direction = std::any_of(sheet.fields.begin(), sheet.fields.end(),
                                           [](const surface::Field& f) { return f.name == kDirection; });
    (has_direction ? out.given : stressed ? out.stress : out.angle) = 1;
    return out;
}

bool keeps_angle(const Options& o) {
    return o.keep == Priority::angle || (o.keep == Priority::usual && o.follow.only(&field::DirectionMix::angle));
}

Plan follow(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    // Hybrid prefers coverage to wide turns: its turns may be half a spacing wide, so its directions may bend as
    // tightly.
    const bool covers = o.algorithm == Algorithm::hybrid;
    const double radius = covers ? o.spacing / 2 : o.least_radius;
    const auto cells = surface::directions::cells(s);
    const auto prescribed = field::prescribed(sheet, cells, directions_followed(sheet, o));
    const auto directions = field::smooth(s, cells, prescribed, field::kSmoothed * o.spacing, radius);
    auto [all, births] = traced(sheet, o, cells, directions);
    const double gentle = std::max(radius, o.spacing / 2), eased = std::max(o.least_radius, gentle);
    ease(s, all, eased, o.spacing);
    if (covers && o.width_change > 0) plan::round_turns(s, all, {o.spacing, o.least_radius, 1 - o.width_change});
    Plan out;
    if (o.turns == RowTurns::none) {
        out.strokes = separate_strokes(std::move(all));
        out.facts.push_back({"", "rows", static_cast<double>(out.strokes.size()), ""});
    } else {
        if (o.backwards) std::reverse(all.begin(), all.end());
        out = cheapest(s, all, o, {gentle, eased});
    }
    out.facts.push_back({"", "cuts", out.strokes.empty() ? 0 : static_cast<double>(out.strokes.size() - 1), ""});
    out.births = std::move(births);
    out.facts.push_back({"", "births", static_cast<double>(out.births.size()), ""});
    report(s, prescribed, directions, out);
    return out;
}

Plan hybrid(const surface::Sheet& sheet, const Options& options) {
    Options o = options;
    o.algorithm = Algorithm::hybrid;
    o.keep = Priority::spacing;
    o.turns = RowTurns::usual;
    return follow(sheet, o);
}

} // namespace filum::surfpath
