#include "surfpath/plan/coarse.hpp"

#include "surface/curve/locate.hpp"
#include "surface/curve/transfer.hpp"
#include "surface/fit/fit.hpp"

#include <cmath>

namespace filum::surfpath::plan {

std::optional<surface::Sheet> coarser(const surface::Sheet& sheet, double longest, double tolerance) {
    const double equilateral = std::sqrt(3.0) / 4 * longest * longest; // mm2
    const double needed = surface::area(sheet.surface) / equilateral;
    if (static_cast<double>(sheet.surface.triangles.size()) < kMuchFiner * needed) return {};
    surface::Sheet out;
    out.surface = surface::fit::fitted(sheet.surface, {longest, tolerance}).surface;
    if (out.surface.triangles.size() >= sheet.surface.triangles.size()) return {};
    out.fields = surface::curve::transferred(sheet.surface, sheet.fields, out.surface);
    return out;
}

void to_given(Plan& plan, const Surface& coarse, const Surface& given) {
    const surface::curve::Locator locator(given);
    for (Stroke& stroke : plan.strokes)
        for (Section& section : stroke.sections)
            for (Place& p : section.line.places) {
                const Place found = locator.nearest(p.point, surface::normal(coarse, p.triangle));
                p = found.triangle == surface::kNone ? locator.nearest(p.point) : found;
            }
}

} // namespace filum::surfpath::plan
