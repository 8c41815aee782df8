#include "infill/squares.hpp"

#include "polygon/clip.hpp"
#include "polygon/stretches.hpp"

#include <cmath>

namespace filum::infill {

namespace {

Loops box(double x0, double y0, double x1, double y1) {
    Loops out;
    out.add(std::vector<geom::Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    return out;
}

} // namespace

Loops whole_squares(const Loops& area, const Loops& within, const Lines& o) {
    if (area.empty()) return {}; // an empty area has no box
    const double s = o.spacing, half = o.bead_width / 2;
    const Loops level = polygon::rotated(area, -o.direction);
    const geom::Box2 all = polygon::bounds(level);
    Loops squares;
    for (double row = std::floor(all.lo.y / s); row * s < all.hi.y; ++row) {
        const Loops strip = polygon::intersect(level, box(all.lo.x - s, row * s, all.hi.x + s, (row + 1) * s));
        for (const Loops& part : polygon::split(strip).part) {
            const geom::Box2 reach = polygon::bounds(part);
            if (reach.hi.y - reach.lo.y < half) continue;
            const double first = std::floor((reach.lo.x + half) / s), last = std::ceil((reach.hi.x - half) / s);
            if (first < last) squares.add(box(first * s, row * s, last * s, (row + 1) * s));
        }
    }
    return polygon::intersect(polygon::rotated(polygon::unite(squares), o.direction), within);
}

} // namespace filum::infill
