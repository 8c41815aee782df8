#include "surfpath/rings.hpp"

#include "base/error.hpp"
#include "curve/ease.hpp"
#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

constexpr double kStretch = 0.1; // of the spacing
constexpr double kRoom = 4;      // radii: how far a corner may move
constexpr double kStep = 0.15;   // mm at a radius of 2.4: of points on rounded corners, in proportion

// The sources, and all rims.
surface::Sources all_sources(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    surface::Sources out = sheet.sources;
    for (const auto& rim : s.rims)
        for (const auto h : rim.sides) out.segments.push_back({h / 3, s.vertices[s.tail(h)], s.vertices[s.head(h)]});
    if (out.empty())
        throw Error(Exit::bad_input, "cannot lay rings on a closed surface without a source; run geodesic --source "
                                     "vertex:ID (or another) first");
    return out;
}

// The spacing near `d` for which the farthest place is a whole number of them and a half away.
double stretched(double farthest, double d) {
    const double n = std::max(1.0, std::floor(farthest / d));
    const double wide = farthest / (n + 0.5), tight = farthest / (n + 1.5);
    const double best = std::abs(wide / d - 1) < std::abs(tight / d - 1) ? wide : tight;
    return std::abs(best / d - 1) <= kStretch ? best : d;
}

// The ring rounded as far as it can be; empty if nothing remains of it.
Line rounded(const Surface& s, const Line& ring, double least, double& radius) {
    for (radius = least; radius > 0.15 * least; radius *= 0.75) {
        const auto eased = curve::ease(s, ring, {.radius = radius, .corridor = kRoom * radius, .step = kStep / 2.4 * radius});
        const double l = curve::length(eased.line);
        if (l > 6.5 * radius && eased.too_tight < 0.1 * radius) return eased.line;
    }
    return {};
}

} // namespace

Rings rings(const surface::Sheet& sheet, const Options& o, Facts& facts) {
    const Surface& s = sheet.surface;
    const auto field = geodesic::exact(s, all_sources(sheet));
    double farthest = 0;
    for (const double d : field.distance)
        if (std::isfinite(d)) farthest = std::max(farthest, d);
    Rings out;
    out.spacing = stretched(farthest, o.spacing);
    std::vector<double> levels;
    for (double l = out.spacing / 2; l <= farthest; l += out.spacing) levels.push_back(l);
    for (const auto& isoline : geodesic::isolines(s, field, levels)) {
        if (!isoline.closed) continue;
        double radius = 0;
        Line line = curve::line(isoline);
        if (o.least_radius > 0) line = rounded(s, line, o.least_radius, radius);
        if (line.size() < 3) continue;
        out.lines.push_back(std::move(line));
        out.level.push_back(static_cast<int>(std::lround(isoline.level / out.spacing - 0.5)));
        out.radius.push_back(radius);
    }
    facts.push_back({"", "rings", static_cast<double>(out.lines.size()), ""});
    facts.push_back({"", "stretch", out.spacing / o.spacing, ""});
    return out;
}

} // namespace filum::surfpath
