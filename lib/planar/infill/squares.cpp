#include "infill/squares.hpp"

#include "infill/ruler.hpp"
#include "polygon/clip.hpp"
#include "polygon/stretches.hpp"

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
    const double half = o.bead_width / 2;
    const Ruler ruler = Ruler::of_squares(o);
    const Loops level = polygon::rotated(area, -o.direction);
    const geom::Box2 all = polygon::bounds(level);
    Loops squares;
    for (double row = ruler.below(all.lo.y); ruler.place(row) < all.hi.y; ++row) {
        const double y0 = ruler.place(row), y1 = ruler.place(row + 1);
        const Loops strip = polygon::intersect(level, box(all.lo.x - 1, y0, all.hi.x + 1, y1));
        for (const Loops& part : polygon::split(strip).part) {
            const geom::Box2 reach = polygon::bounds(part);
            if (reach.hi.y - reach.lo.y < half) continue;
            const double x0 = ruler.place(ruler.below(reach.lo.x + half));
            const double x1 = ruler.place(ruler.below(reach.hi.x - half) + 1);
            if (x0 < x1) squares.add(box(x0, y0, x1, y1));
        }
    }
    return polygon::intersect(polygon::rotated(polygon::unite(squares), o.direction), within);
}

} // namespace filum::infill
