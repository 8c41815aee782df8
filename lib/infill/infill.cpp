#include "infill/infill.hpp"

#include "polygon/clip.hpp"

#include <cmath>

namespace filum::infill {

namespace {

using geom::Vec2;

constexpr double kArc = 0.01; // mm, of round corners

// The even cells of rows that meet the box of `area`, as rectangles.
Loops even_rows(const Loops& area, const Lines& o) {
    const Vec2 along{std::cos(o.direction), std::sin(o.direction)}, across = geom::left_of(along);
    geom::Box2 box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const Vec2 p : area.points) {
        const Vec2 q{dot(p, along), dot(p, across)};
        box.lo = {std::min(box.lo.x, q.x), std::min(box.lo.y, q.y)};
        box.hi = {std::max(box.hi.x, q.x), std::max(box.hi.y, q.y)};
    }
    Loops out;
    for (double k = 2 * std::floor(box.lo.y / o.spacing / 2); k * o.spacing < box.hi.y; k += 2) {
        const double v0 = k * o.spacing, v1 = (k + 1) * o.spacing, u0 = box.lo.x - 1, u1 = box.hi.x + 1;
        const Vec2 corners[] = {u0 * along + v0 * across, u1 * along + v0 * across, u1 * along + v1 * across,
                                u0 * along + v1 * across};
        out.add(corners);
    }
    return out;
}

} // namespace

Loops loops(const Loops& area, const Lines& o) {
    const double half = o.bead_width / 2;
    const Loops inner = polygon::offset(area, -half, kArc);
    if (inner.empty()) return {};
    const Loops cells = polygon::intersect(inner, even_rows(inner, o));
    return polygon::offset(polygon::offset(cells, -half, kArc), half, kArc);
}

double length(const Loops& loops) {
    double sum = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) sum += polygon::perimeter(loops[i]);
    return sum;
}

} // namespace filum::infill
