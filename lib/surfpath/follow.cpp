#include "surfpath/follow.hpp"

#include "surface/curve/ease.hpp"
#include "surfpath/boustrophedon.hpp"
#include "surfpath/field/stripes.hpp"
#include "surfpath/winding.hpp"

#include <algorithm>

namespace filum::surfpath {

namespace {

constexpr double kSmoothed = 0.2; // spacings: what is smaller, of directions, lines cannot follow
constexpr double kGive = 0.25;    // spacings: how far lines may move to keep the radius

field::Sources sources(const surface::Sheet& sheet, field::Sources given) {
    if (given.given > 0 || given.stress > 0 || given.angle > 0 || given.rim > 0) return given;
    const bool stressed = std::any_of(sheet.fields.begin(), sheet.fields.end(), [](const surface::Field& f) {
        return f.name.starts_with("stress.") && f.name.ends_with(".d1");
    });
    const bool said = std::any_of(sheet.fields.begin(), sheet.fields.end(),
                                  [](const surface::Field& f) { return f.name == kDirection; });
    (said ? given.given : stressed ? given.stress : given.angle) = 1;
    return given;
}

void tell(const Surface& s, const field::Directions& d, Plan& out) {
    out.facts.push_back({"", "tightest-bend", d.tightest, "1/mm"});
    const auto note = [&](const char* what, double amount) {
        out.notes.push_back({"", what, amount, "mm2", 1, -1, d.tight_at.x, d.tight_at.y, d.tight_at.z});
    };
    if (d.tight > 0) note("field bends tighter than the least radius", d.tight);
    if (d.given_up > 0.01 * surface::area(s))
        note("field does not follow what is asked, to keep the radius", d.given_up);
}

} // namespace

Plan follow(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    const auto cells = surface::directions::cells(s);
    const auto wanted = field::wanted(sheet, cells, sources(sheet, o.follow));
    const auto directions = field::smooth(s, cells, wanted, kSmoothed * o.spacing, o.least_radius);
    auto all = field::lines(s, field::stripes(s, cells, directions.along, o.spacing));
    const double gentle = std::max(o.least_radius, o.spacing / 2);
    for (Line& l : all) l = surface::curve::ease(s, l, {.radius = gentle, .corridor = kGive * o.spacing}).line;
    Plan out;
    if (o.turns == RowTurns::none) {
        for (Line& l : all) out.strokes.push_back({{{std::move(l), false}}});
        out.facts.push_back({"", "rows", static_cast<double>(out.strokes.size()), ""});
    } else {
        std::vector<Raw> raw;
        for (std::size_t i = 0; i < all.size(); ++i)
            raw.push_back({std::move(all[i]), o.spacing * static_cast<double>(i)});
        const Turning turns = turning(o.spacing, o.turns == RowTurns::hairpin ? 0 : o.least_radius);
        Rows found = rows(s, raw, o.spacing / 2, o.spacing / 2);
        wind(s, found, o.spacing, false);
        out = boustrophedon(s, found, turns);
    }
    out.facts.push_back({"", "cuts", out.strokes.empty() ? 0 : static_cast<double>(out.strokes.size() - 1), ""});
    tell(s, directions, out);
    return out;
}

} // namespace filum::surfpath
