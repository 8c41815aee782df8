#include "surfpath/fina.hpp"

#include "base/error.hpp"
#include "surfpath/capped.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/winding.hpp"
#include "surfpath/rules/rules.hpp"
#include "surfpath/seed_side.hpp"

namespace filum::surfpath {

Plan fina(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    if (sheet.sources.segments.empty())
        throw Error(Exit::bad_input, "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first");
    // Distances are measured on the surface with its holes closed, so that rows stay straight behind holes.
    const Surface closed = capped(s);
    const auto field = geodesic::exact(closed, bridged(s, closed, sheet.sources));
    std::vector<rows::UnclippedLine> raw;
    double sign = 1;
    const bool fitted = o.beyond.empty(); // the rim of a flange is not an end of the part
    for (const auto& side : side_rows(s, closed, field, sheet.sources, o.spacing, fitted)) {
        add(raw, side, sign);
        sign = -sign;
    }
    rows::leave_out(raw, o.beyond);
    rows::TurnOptions turns = rows::turn_options(o.spacing, o.least_radius, o.turns == RowTurns::hairpin);
    turns.staggered = o.beyond.empty();
    rows::Rows all =
        rows::rows(s, raw, {o.spacing / 2, 2 * turns.least_radius, turns.least_radius, rules::kMostGive * o.spacing});
    rows::wind(s, all, o.spacing, true);
    return rows::boustrophedon(s, all, turns);
}

} // namespace filum::surfpath
