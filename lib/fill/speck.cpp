#include "fill/speck.hpp"

namespace filum::fill {

namespace {

constexpr double kSpeckArea = 0.5; // bead widths squared
constexpr double kBreadth = 0.004; // mm, at least: two lanes of 2 um

struct Rectangle {
    Vec2 centre, along; // unit: of the longer side
    double length = 0, breadth = 0;
};

Rectangle about(std::span<const Vec2> points, Vec2 along) {
    geom::Box2 box;
    for (const Vec2 p : points) box.add({geom::dot(p, along), geom::cross(along, p)});
    const Vec2 size = box.hi - box.lo, middle = 0.5 * (box.lo + box.hi);
    const Vec2 centre = middle.x * along + middle.y * geom::left_of(along);
    return size.x >= size.y ? Rectangle{centre, along, size.x, size.y}
                            : Rectangle{centre, geom::left_of(along), size.y, size.x};
}

Rectangle smallest(std::span<const Vec2> points) {
    Rectangle best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 d = points[i + 1 == points.size() ? 0 : i + 1] - points[i];
        if (geom::norm(d) == 0) continue;
        const Rectangle r = about(points, (1 / geom::norm(d)) * d);
        if (best.length == 0 || r.length * r.breadth < best.length * best.breadth) best = r;
    }
    return best;
}

} // namespace

bool is_speck(const Loops& region, double width) {
    return region.size() == 1 && polygon::signed_area(region) < kSpeckArea * width * width;
}

ClosedLine speck_loop(const Loops& region) {
    const Rectangle r = smallest(region[0]);
    const double lane = std::max(r.breadth, kBreadth) / 2, length = std::max(r.length, kBreadth);
    const Vec2 x = (length / 2 - lane / 2) * r.along, y = (lane / 2) * geom::left_of(r.along);
    const double width = 1.35 * lane; // the round ends of lanes leave the corners of a rectangle bare, rounding more
    return {{r.centre - x - y, r.centre + x - y, r.centre + x + y, r.centre - x + y}, {width, width, width, width}};
}

} // namespace filum::fill
