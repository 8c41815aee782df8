#include "surfpath/follow.hpp"

#include "surface/curve/ease.hpp"
#include "surfpath/field/rings.hpp"
#include "surfpath/field/stripes.hpp"
#include "surfpath/plan/in_turn.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/loops.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

constexpr double kSmoothed = 0.2; // spacings: what is smaller, of directions, lines cannot follow
constexpr double kAcross = 10;    // spacings: ways over other lines, at most
constexpr double kEasedTo = 1.15; // of the least radius: what lines are eased to, so that samples of them keep it
constexpr double kGive =
    0.1; // spacings: how far lines may move to keep the radius; more would cut off the turns of pairs

field::Sources sources(const surface::Sheet& sheet, field::Sources given) {
    if (!given.only(nullptr)) return given;
    const bool stressed = std::any_of(sheet.fields.begin(), sheet.fields.end(), [](const surface::Field& f) {
        return f.name.starts_with("stress.") && f.name.ends_with(".d1");
    });
    const bool said = std::any_of(sheet.fields.begin(), sheet.fields.end(),
                                  [](const surface::Field& f) { return f.name == kDirection; });
    (said ? given.given : stressed ? given.stress : given.angle) = 1;
    return given;
}

// Each a stroke by itself.
std::vector<Stroke> apart(std::vector<Line> lines) {
    std::vector<plan::Ends> ends;
    ends.reserve(lines.size());
    for (const Line& l : lines) ends.push_back({l[0], l.closed ? l[0] : l[l.size() - 1]});
    std::vector<Stroke> out;
    for (const plan::Visit& visit : plan::in_turn(ends)) {
        if (visit.reversed) surface::curve::reverse(lines[visit.row]);
        out.push_back({{{std::move(lines[visit.row]), false}}});
    }
    return out;
}

void tell(const Surface& s, const field::Wanted& wanted, const field::Directions& d, Plan& out) {
    out.facts.push_back({"", "tightest-bend", d.tightest, "1/mm"});
    const auto note = [&](NoteCode code, double amount, const geom::Vec3& at) {
        out.notes.push_back({code, amount, 1, -1, at.x, at.y, at.z});
    };
    if (d.tight > 0) note(NoteCode::field_too_tight, d.tight, d.tight_at);
    if (d.given_up > 0.01 * surface::area(s)) note(NoteCode::field_given_up, d.given_up, d.tight_at);
    if (wanted.unknown > 0) note(NoteCode::direction_unknown, wanted.unknown, wanted.unknown_at);
}

// Lines eased to a radius, as far as their corridor allows.
void ease(const Surface& s, std::vector<Line>& lines, double radius, double spacing) {
    for (Line& l : lines)
        l = surface::curve::ease(s, l, {.radius = kEasedTo * radius, .corridor = kGive * spacing}).line;
}

} // namespace

bool keeps_angle(const Options& o) {
    return o.keep == Keep::angle || (o.keep == Keep::usual && o.follow.only(&field::Sources::angle));
}

Plan follow(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    // Hybrid covers rather than turns gently: its turns may be half a spacing wide, so its directions may bend as much.
    const bool covers = o.algorithm == Algorithm::hybrid;
    const double radius = covers ? o.spacing / 2 : o.least_radius;
    const auto cells = surface::directions::cells(s);
    const auto wanted = field::wanted(sheet, cells, sources(sheet, o.follow));
    const auto directions = field::smooth(s, cells, wanted, kSmoothed * o.spacing, radius);
    field::Striping striping{o.spacing, o.shift, keeps_angle(o) ? field::kTrue : field::kEven};
    striping.apart = o.births_apart;
    std::vector<field::Complex> like;
    if (o.follow.only(&field::Sources::rings)) {
        like = field::phase(field::rings(sheet, cells), directions.along, o.spacing);
        striping.like = like;
    }
    const auto stripes = field::stripes(s, cells, directions.along, striping);
    auto all = field::lines(s, stripes);
    const double gentle = std::max(radius, o.spacing / 2), eased = std::max(o.least_radius, gentle);
    ease(s, all, eased, o.spacing);
    Plan out;
    if (o.turns == RowTurns::none) {
        out.strokes = apart(std::move(all));
        out.facts.push_back({"", "rows", static_cast<double>(out.strokes.size()), ""});
    } else {
        if (o.backwards) std::reverse(all.begin(), all.end());
        std::vector<rows::Raw> raw;
        raw.reserve(all.size());
        for (Line& l : all) raw.push_back({std::move(l), o.spacing * static_cast<double>(raw.size())});
        rows::leave_out(raw, o.beyond);
        rows::Turning turns = rows::turning(o.spacing, o.turns == RowTurns::hairpin ? 0 : o.least_radius);
        turns.across = kAcross * o.spacing;
        turns.along = o.cut_length;
        turns.staggered = o.beyond.empty();
        turns.tight = covers;
        rows::Rows found = rows::rows(s, raw, {o.spacing / 2, o.spacing / 2, gentle, kGive * o.spacing});
        const auto joined = rows::open_loops(s, found, {o.spacing, gentle, eased, o.cut_length, turns.tight});
        out = rows::boustrophedon(s, found, turns);
        rows::tell_crossed(joined.crossed, o.spacing, out.notes);
        out.facts.push_back({"", "loops-joined", static_cast<double>(joined.crossed.size() + joined.exchanged), ""});
    }
    out.facts.push_back({"", "cuts", out.strokes.empty() ? 0 : static_cast<double>(out.strokes.size() - 1), ""});
    out.births = field::births(s, stripes);
    out.facts.push_back({"", "births", static_cast<double>(out.births.size()), ""});
    tell(s, wanted, directions, out);
    return out;
}

Plan hybrid(const surface::Sheet& sheet, const Options& options) {
    Options o = options;
    o.algorithm = Algorithm::hybrid;
    o.follow = {.rings = 1};
    o.keep = Keep::spacing;
    o.turns = RowTurns::usual;
    return follow(sheet, o);
}

} // namespace filum::surfpath
