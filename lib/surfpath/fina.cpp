#include "surfpath/fina.hpp"

#include "base/error.hpp"
#include "geodesic/isolines.hpp"
#include "surfpath/boustrophedon.hpp"

#include <algorithm>
#include <cmath>

namespace filum::surfpath {

namespace {

using surface::kNone;

// Which side of the seed a triangle lies on: those that hang together when all that hold seed segments are left out.
struct Sides {
    std::vector<std::uint32_t> of; // per triangle, kNone on the seed
    std::vector<double> farthest;  // per side, mm
};

Sides sides(const Surface& s, const surface::Sources& seed, std::span<const double> distance) {
    std::vector<char> on_seed(s.triangles.size(), 0);
    for (const auto& g : seed.segments) on_seed[g.triangle] = 1;
    Sides out{std::vector<std::uint32_t>(s.triangles.size(), kNone), {}};
    std::vector<std::uint32_t> stack;
    for (std::uint32_t first = 0; first < s.triangles.size(); ++first) {
        if (on_seed[first] || out.of[first] != kNone) continue;
        const auto side = static_cast<std::uint32_t>(out.farthest.size());
        out.farthest.push_back(0);
        stack.assign(1, first);
        out.of[first] = side;
        while (!stack.empty()) {
            const std::uint32_t t = stack.back();
            stack.pop_back();
            for (std::uint32_t k = 0; k < 3; ++k) {
                const double d = distance[s.triangles[t][k]];
                if (std::isfinite(d)) out.farthest[side] = std::max(out.farthest[side], d);
                const std::uint32_t twin = s.twin[3 * t + k];
                if (twin == kNone || on_seed[twin / 3] || out.of[twin / 3] != kNone) continue;
                out.of[twin / 3] = side;
                stack.push_back(twin / 3);
            }
        }
    }
    return out;
}

std::uint32_t side_of(const surface::Isoline& line, const Sides& sides) {
    std::vector<std::uint32_t> count(sides.farthest.size(), 0);
    for (const std::uint32_t t : line.triangles)
        if (sides.of[t] != kNone) ++count[sides.of[t]];
    const auto most = std::max_element(count.begin(), count.end());
    return most == count.end() || *most == 0 ? kNone : static_cast<std::uint32_t>(most - count.begin());
}

} // namespace

Plan fina(const surface::Sheet& sheet, const Options& o) {
    const Surface& s = sheet.surface;
    if (sheet.sources.segments.empty())
        throw Error(Exit::bad_input, "needs a seed curve; run geodesic --source plane:NX,NY,NZ,D first");
    const auto field = geodesic::exact(s, sheet.sources);
    const Sides where = sides(s, sheet.sources, field.distance);
    std::vector<Raw> raw;
    for (std::uint32_t side = 0; side < where.farthest.size(); ++side) {
        const double far = where.farthest[side], n = std::round(far / o.spacing);
        const double step = n > 0 ? far / n : o.spacing;
        const double d = std::abs(step / o.spacing - 1) <= 0.1 ? step : o.spacing;
        std::vector<double> levels;
        for (double level = d / 2; level < far; level += d) levels.push_back(level);
        for (const auto& line : geodesic::isolines(s, field, levels))
            if (side_of(line, where) == side) raw.push_back({curve::line(line), side % 2 == 0 ? line.level : -line.level});
    }
    return boustrophedon(s, rows(s, raw, o.spacing / 2), {o.spacing, o.least_radius});
}

} // namespace filum::surfpath
