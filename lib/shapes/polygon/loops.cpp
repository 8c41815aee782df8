#include "polygon/loops.hpp"

namespace filum::polygon {

double signed_area(std::span<const Vec2> loop) {
    if (loop.size() < 3) return 0;
    double twice = 0; // relative to the first point, so that no digits are lost far from the origin
    const Vec2 o = loop[0];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) twice += geom::cross(loop[i] - o, loop[i + 1] - o);
    return twice / 2;
}

double signed_area(const Loops& loops) {
    double sum = 0;
    for (std::size_t i = 0; i < loops.size(); ++i) sum += signed_area(loops[i]);
    return sum;
}

Vec2 centroid(const Loops& loops) {
    if (loops.empty()) return {};
    const Vec2 o = loops.points[0];
    double twice = 0;
    Vec2 sum;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        const auto loop = loops[l];
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) { // triangles from the loop's first point
            const Vec2 a = loop[0] - o, b = loop[i] - o, c = loop[i + 1] - o;
            const double t = geom::cross(b - a, c - a);
            twice += t;
            sum = sum + (t / 3) * (a + b + c);
        }
    }
    return twice == 0 ? o : o + (1 / twice) * sum;
}

double perimeter(std::span<const Vec2> loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) sum += geom::distance(loop[i], loop[(i + 1) % loop.size()]);
    return sum;
}

Box2 bounds(std::span<const Vec2> points) {
    Box2 box;
    for (const Vec2 p : points) box.add(p);
    return box;
}

bool contains(const Loops& loops, Vec2 p) {
    bool inside = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const auto loop = loops[i];
        for (std::size_t j = 0, k = loop.size() - 1; j < loop.size(); k = j++) {
            const Vec2 a = loop[k], b = loop[j];
            if ((a.y > p.y) == (b.y > p.y)) continue;
            if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
        }
    }
    return inside;
}

} // namespace filum::polygon
