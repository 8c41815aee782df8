#include "surfpath/fina.hpp"

#include "base/error.hpp"
#include "surfpath/boustrophedon.hpp"
#include "surfpath/capped.hpp"
#include "surfpath/seed_side.hpp"
#include "surfpath/winding.hpp"

#include <cmath>

namespace filum::surfpath {

Plan fina(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    if (sheet.sources.segments.empty())
        throw Error(Exit::bad_input, "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first");
    // Distances are measured past holes as if there were none: so rows stay straight behind them.
    const Surface closed = capped(s);
    const auto field = geodesic::exact(closed, bridged(s, closed, sheet.sources));
    const SeedSides sides = seed_sides(s, sheet.sources);
    std::vector<Raw> raw;
    for (std::uint32_t side = 0; side < sides.count; ++side) {
        const double sign = side % 2 == 0 ? 1 : -1;
        add(raw, side_rows(s, closed, field, sides, side, o.spacing), sign);
    }
    Rows all = rows(s, raw, o.spacing / 2, 2 * o.least_radius);
    wind(s, all, o.spacing, true);
    return boustrophedon(s, all, {o.spacing, o.least_radius});
}

} // namespace filum::surfpath
