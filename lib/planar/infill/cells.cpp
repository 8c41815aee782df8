#include "infill/cells.hpp"

#include "infill/ruler.hpp"
#include "infill/strips.hpp"
#include "infill/waves.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace filum::infill {

namespace {

using geom::Vec2;
using polygon::InfillPattern;

constexpr double kBeyond = 1; // mm that cells reach beyond the area

// The box of the points in a frame with the x axis along `along`.
geom::Box2 box_along(const Loops& area, Vec2 along) {
    const Vec2 across = geom::left_of(along);
    geom::Box2 box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const Vec2 p : area.points) {
        const Vec2 q{dot(p, along), dot(p, across)};
        box.lo = {std::min(box.lo.x, q.x), std::min(box.lo.y, q.y)};
        box.hi = {std::max(box.hi.x, q.x), std::max(box.hi.y, q.y)};
    }
    return box;
}

Loops even_rows(const Loops& area, const Lines& o) {
    const Vec2 along{std::cos(o.direction), std::sin(o.direction)}, across = geom::left_of(along);
    const auto box = box_along(area, along);
    const Ruler ruler(o);
    Loops out;
    for (double k = 2 * std::floor(ruler.line(box.lo.y) / 2); ruler.place(k) < box.hi.y; k += 2) {
        const double v0 = ruler.place(k), v1 = ruler.place(k + 1), u0 = box.lo.x - kBeyond, u1 = box.hi.x + kBeyond;
        const Vec2 corners[] = {u0 * along + v0 * across, u1 * along + v0 * across, u1 * along + v1 * across,
                                u0 * along + v1 * across};
        out.add(corners);
    }
    return out;
}

// Bands between lines 2 k and 2 k + 1 of the waves.
Loops even_waves(const Loops& area, const Lines& o) {
    const bool along_x = Waves::along_x(o);
    const geom::Box2 box = polygon::bounds(area);
    const double u0 = (along_x ? box.lo.x : box.lo.y) - kBeyond, u1 = (along_x ? box.hi.x : box.hi.y) + kBeyond;
    const double v0 = along_x ? box.lo.y : box.lo.x, v1 = along_x ? box.hi.y : box.hi.x;
    const Waves waves(o, u0, u1);
    const std::int64_t first = waves.column(u0), last = waves.column(u1) + 1;
    std::int64_t least = waves.below(first, u0, v0), most = least; // lines that may meet the area
    for (std::int64_t c = first; c < last; ++c) {
        least = std::min(least, waves.below(c, waves.knot(c), v0));
        most = std::max(most, waves.below(c, waves.knot(c), v1));
    }
    Loops out;
    for (std::int64_t j = least - (least % 2 == 0 ? 0 : 1) - 2; j <= most + 2; j += 2) {
        const std::size_t begin = out.points.size();
        const auto add = [&](std::int64_t i, std::int64_t line) {
            const double u = waves.knot(i), v = waves.at(std::min(i, last - 1), u, line);
            out.points.push_back(along_x ? Vec2{u, v} : Vec2{v, u});
        };
        for (std::int64_t i = first; i <= last; ++i) add(i, j);
        for (std::int64_t i = last; i >= first; --i) add(i, j + 1);
        if (!along_x) std::reverse(out.points.begin() + static_cast<std::ptrdiff_t>(begin), out.points.end());
        out.close();
    }
    return out;
}

// Bands along the rim, from every odd line to the next one. Without further lines (Ruler), line k lies k - 1/2 spacings
// inside the rim. So lines are evenly spaced, with half a spacing between the rim and the first of them.
Loops even_bands(const Lines& o) {
    const Ruler ruler(o);
    const auto inside = [&](double line) {
        return polygon::offset(*o.rim, std::min(0.0, o.spacing / 2 - ruler.place(line)), polygon::kBeadArc);
    };
    Loops out;
    for (double j = 1;; j += 2) { // line 0 lies half a spacing outside the rim
        if (ruler.place(j + 1) <= o.spacing / 2) continue;
        const Loops band = inside(j);
        if (band.empty()) return out;
        const Loops hole = inside(j + 1);
        out.add(hole.empty() ? band : polygon::subtract(band, hole));
    }
}

double even_length_rows(const Loops& area, const Lines& o) {
    const Vec2 along{std::cos(o.direction), std::sin(o.direction)}, across = geom::left_of(along);
    const Ruler ruler(o);
    double out = 0;
    for (std::size_t l = 0; l < area.size(); ++l) {
        const auto loop = area[l];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 p = loop[i], q = loop[i + 1 == loop.size() ? 0 : i + 1];
            const double a = dot(p, across), b = dot(q, across), u = ruler.line(a), v = ruler.line(b);
            const double sign = v > u ? 1 : -1;
            for (double k = std::ceil(std::min(u, v)); k < std::max(u, v); ++k) // line k enters or leaves here
                out += sign * dot(geom::lerp(p, q, (ruler.place(k) - a) / (b - a)), along);
            const double even = a != b ? (ruler.even(b) - ruler.even(a)) / (b - a)
                                       : (static_cast<std::int64_t>(std::floor(u)) % 2 == 0 ? 1 : 0);
            out += even * geom::distance(p, q);
        }
    }
    return out;
}

} // namespace

Loops even_cells(const Loops& area, const Lines& o) {
    if (area.empty()) return {}; // an empty area has no box
    if (o.pattern == InfillPattern::wave) return even_waves(area, o);
    return o.pattern == InfillPattern::concentric ? even_bands(o) : even_rows(area, o);
}

Loops cells_in(const Loops& area, const Lines& o) {
    if (o.pattern != InfillPattern::concentric)
        if (auto cells = in_even_cells(area, o)) return std::move(*cells);
    return polygon::intersect(area, even_cells(area, o));
}

double even_length(const Loops& area, const Lines& o) {
    if (o.pattern == InfillPattern::rows) return even_length_rows(area, o);
    const double endless = polygon::signed_area(area) / near_enough(o);
    if (o.pattern == InfillPattern::concentric) return endless;
    const double spacing = near_enough(o),
                 followed = even_width(o, spacing) / (2 * spacing); // of the outline, on average
    return endless + followed * length(area);
}

} // namespace filum::infill
