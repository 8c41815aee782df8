#include "surfpath/geo_spiral.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/boustrophedon.hpp"
#include "surfpath/capped.hpp"
#include "surfpath/winding.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

constexpr double kFirst = 0.42; // of the least radius: that of the first lap

bool is_point(const surface::Sources& sources) {
    if (sources.vertices.size() + sources.segments.size() != 1) return false;
    return sources.segments.empty() || sources.segments[0].a == sources.segments[0].b;
}

} // namespace

Plan geo_spiral(const surface::Sheet& sheet, const Options& o) {
    if (!is_point(sheet.sources))
        throw Error(Exit::bad_input, "needs a seed point; run geodesic --source point:X,Y,Z first");
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(capped(s), sheet.sources);
    double farthest = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    std::vector<double> levels;
    const double first = std::max(o.spacing / 2, kFirst * o.least_radius);
    for (double i = 0; first + i * o.spacing < farthest; ++i) levels.push_back(first + i * o.spacing);
    std::vector<Raw> raw;
    add(raw, geodesic::isolines(s, field, levels), 1);
    const Turning turns = turning(o.spacing, o.least_radius);
    Rows all = rows(s, raw, {o.spacing / 2, 2 * turns.least_radius, turns.least_radius, o.spacing / 4});
    wind(s, all, o.spacing, false);
    return boustrophedon(s, all, turns);
}

} // namespace filum::surfpath
