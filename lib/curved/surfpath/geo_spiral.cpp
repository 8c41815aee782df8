#include "surfpath/geo_spiral.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/capped.hpp"
#include "surfpath/rings/branches.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/winding.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::surfpath {

namespace {

constexpr double kFirst = 0.42; // radius of the first lap, in least radii

bool is_point(const surface::Sources& sources) {
    if (sources.vertices.size() + sources.segments.size() != 1) return false;
    return sources.segments.empty() || sources.segments[0].a == sources.segments[0].b;
}

// Levels of the laps: from `first` in steps of a spacing. If the last front is longer than a circle of the least
// radius, the steps are stretched or shrunk by up to a tenth, so that the last lap lies half a spacing before the
// farthest place (rings/branches.hpp). A shorter front ends in a corner and needs no lap there.
std::vector<double> laps(const Surface& s, const geodesic::ExactField& field, double first, const Options& o,
                         Facts& facts) {
    const double spacing = o.spacing;
    double farthest = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    std::vector<double> even;
    for (double i = 0; first + i * spacing < farthest; ++i) even.push_back(first + i * spacing);
    std::vector<rings::Isle> isles;
    const double before = first - spacing / 2;
    for (std::uint32_t i = 0; i < even.size(); ++i)
        isles.push_back({i, i == 0 ? surface::kNone : i - 1, farthest - before, 0, 0, {}});
    for (const auto& line : geodesic::isolines(s, field, even)) {
        rings::Isle& own =
            isles[static_cast<std::size_t>(std::lower_bound(even.begin(), even.end(), line.level) - even.begin())];
        const double length = surface::curve::length(surface::curve::line(line));
        own.around += length;
        own.longest = std::max(own.longest, length);
    }
    if (isles.empty() || isles.back().longest < 2 * std::numbers::pi * o.least_radius) return even;
    std::vector<std::uint32_t> of;
    rings::Branch only = branches(isles, {spacing, 0, false}, of).at(0);
    facts.push_back({"", "spacing-change", only.widest / spacing, ""});
    for (double& level : only.levels) level += before;
    return std::move(only.levels);
}

} // namespace

Plan geo_spiral(const surface::Sheet& sheet, const Options& o) {
    if (!is_point(sheet.sources))
        throw Error(Exit::bad_input, "needs a seed point; run geodesic --source point:X,Y,Z first");
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(capped(s), sheet.sources);
    const double first = std::max(o.spacing / 2, kFirst * o.least_radius);
    Facts facts;
    const auto levels = laps(s, field, first, o, facts);
    std::vector<rows::UnclippedLine> raw;
    add(raw, geodesic::isolines(s, field, levels), 1);
    const rows::TurnOptions turns = rows::turn_options(o.spacing, o.least_radius);
    rows::Rows all =
        rows::rows(s, raw, {o.spacing / 2, 2 * turns.least_radius, turns.least_radius, rules::kMostGive * o.spacing});
    rows::wind(s, all, o.spacing, false);
    Plan out = rows::boustrophedon(s, all, turns);
    out.facts.insert(out.facts.end(), facts.begin(), facts.end());
    return out;
}

} // namespace filum::surfpath
