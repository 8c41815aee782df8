#include "surfpath/plan/coarse.hpp"

#include "surface/curve/transfer.hpp"
#include "surface/fit/fit.hpp"
#include "surface/fit/fitter.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surfpath::plan {

std::optional<double> coarse_side(const Surface& surface, double longest) {
    const double area = surface::area(surface), given = static_cast<double>(surface.triangles.size());
    const auto needed = [&](double side) { return area / (std::numbers::sqrt3 / 4 * side * side); };
    if (given >= needed(rules::kGrain * longest)) return longest;
    const double most = rules::kMostPieces, side = longest * std::sqrt(std::max(1.0, needed(longest) / most));
    if (given > most && given >= kTwice * needed(side)) return side;
    return {};
}

surface::Sheet coarser(const surface::Sheet& sheet, const surface::curve::Locator& locator, double side,
                       double tolerance) {
    surface::Sheet out;
    out.surface = surface::fit::fitted(sheet.surface, locator, {side / surface::fit::kLong, tolerance}).surface;
    out.fields = surface::curve::transferred(sheet.surface, locator, sheet.fields, out.surface);
    return out;
}

void to_given(Plan& plan, const Surface& coarse, const surface::curve::Locator& given) {
    for (Stroke& stroke : plan.strokes)
        for (Section& section : stroke.sections)
            for (Place& p : section.line.places) {
                const Place found = given.nearest(p.point, surface::normal(coarse, p.triangle));
                p = found.triangle == surface::kNone ? given.nearest(p.point) : found;
            }
}

} // namespace filum::surfpath::plan
