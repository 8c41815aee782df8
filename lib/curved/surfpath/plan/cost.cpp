#include "surfpath/plan/cost.hpp"

#include "surfpath/plan/coverage.hpp"
#include "surfpath/plan/declare.hpp"
#include "surfpath/plan/widths.hpp"

#include <limits>

namespace filum::surfpath::plan {

double cost(const Surface& surface, Plan plan, const CostOptions& o) {
    if (plan.strokes.empty()) return std::numeric_limits<double>::infinity();
    const TightTurns tight = mark_tight_turns(surface, plan, {.radius = o.radius, .spacing = o.spacing});
    if (o.width_change > 0) fit_widths(surface, plan, {o.spacing, o.width_change});
    const Coverage area = cover(surface, plan, o.spacing);
    const double cuts = o.cut * static_cast<double>(plan.strokes.size() - 1);
    return area.voids() + area.overlap() + o.spacing * (tight.length + tight.kinks + cuts);
}

} // namespace filum::surfpath::plan
