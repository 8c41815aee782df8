#include "link3d/travel.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <array>

namespace filum::link3d {

namespace {

constexpr double kTouch = 1e-6; // mm

// Whether a -> b meets the box grown by `margin` mm on all sides.
bool passes(Vec2 a, Vec2 b, const Box2& box, double margin) {
    double from = 0, to = 1;
    const auto clip = [&](double p, double d, double lo, double hi) {
        if (d == 0) return p >= lo && p <= hi;
        const double s = (lo - p) / d, t = (hi - p) / d;
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
        return from <= to;
    };
    return clip(a.x, b.x - a.x, box.lo.x - margin, box.hi.x + margin) &&
           clip(a.y, b.y - a.y, box.lo.y - margin, box.hi.y + margin);
}

} // namespace

void PrintedBodies::add(const Box2& lines, double width, double top) {
    bodies.back().box.add(lines.lo);
    bodies.back().box.add(lines.hi);
    bodies.back().half = std::max(bodies.back().half, width / 2);
    bodies.back().top = std::max(bodies.back().top, top);
}

Box2 PrintedBodies::bounds() const {
    Box2 out;
    for (const auto& b : bodies)
        if (b.part && !b.box.empty()) {
            out.add(b.box.lo);
            out.add(b.box.hi);
        }
    return out;
}

double PrintedBodies::widest() const {
    double half = 0;
    for (const auto& b : bodies) half = std::max(half, b.half);
    return 2 * half;
}

bool PrintedBodies::blocks(Vec3 a, Vec3 b, double z, double margin, bool own) const {
    for (std::size_t i = 0; i + (own ? 1 : 0) < bodies.size(); ++i)
        if (!bodies[i].strand && bodies[i].top > z && passes(a.xy(), b.xy(), bodies[i].box, margin)) return true;
    return false;
}

void PrintedBodies::connector(std::span<const Vec3> way, double width) {
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        Box2 box;
        box.add(way[i].xy());
        box.add(way[i + 1].xy());
        bodies.push_back({box, std::max(way[i].z, way[i + 1].z), width / 2, false});
    }
}

void PrintedBodies::strand(Vec3 a, Vec3 b, double width) {
    connector(std::array{a, b}, width);
    bodies.back().strand = true;
}

bool PrintedBodies::hits(Vec3 a, Vec3 b, const machine::Head& head) const {
    if (head.none) return false;
    const double z = std::min(a.z, b.z), carriage = std::max(head.carriage_x, head.carriage_y) / 2;
    return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
        const double up = body.top - z;
        if (up <= kTouch) return false;
        if (up > head.gantry_height) return true;
        return passes(a.xy(), b.xy(), body.box, body.half + (up > head.cone_height ? carriage : head.cone_radius(up)));
    });
}

bool PrintedBodies::meets_itself(std::span<const Vec3> way, double width, const machine::Head& head) {
    for (std::size_t i = 2; i + 1 < way.size(); ++i) {
        PrintedBodies before;
        before.connector(way.first(i), width);
        if (before.hits(way[i], way[i + 1], head) || before.blocks(way[i], way[i + 1], -1, width, false)) return true;
    }
    return false;
}

std::vector<Vec3> travel(const PrintedBodies& printed, Vec3 from, Vec3 to, const machine::Head& head) {
    const double level = std::max(from.z, to.z);
    const double cone = head.cone_radius(head.cone_height), carriage = std::max(head.carriage_x, head.carriage_y) / 2;
    double z = level;
    for (const auto& b : printed.bodies) {
        if (head.none || b.top <= level) continue;
        if (passes(from.xy(), to.xy(), b.box, b.half + cone))
            z = std::max(z, b.top);
        else if (passes(from.xy(), to.xy(), b.box, b.half + carriage))
            z = std::max(z, b.top - head.cone_height);
    }
    std::vector<Vec3> out{from};
    for (const Vec3 p : {Vec3{from.x, from.y, z}, Vec3{to.x, to.y, z}, to})
        if (p != out.back()) out.push_back(p);
    if (out.size() == 1) out.push_back(to);
    return out;
}

namespace {

// The position of a point on the box's border, counter-clockwise from its lower left corner, mm.
double along(const Box2& box, Vec2 p) {
    const double w = box.hi.x - box.lo.x, h = box.hi.y - box.lo.y;
    if (p.y == box.lo.y) return p.x - box.lo.x;
    if (p.x == box.hi.x) return w + (p.y - box.lo.y);
    if (p.y == box.hi.y) return w + h + (box.hi.x - p.x);
    return 2 * w + h + (box.hi.y - p.y);
}

// The corners between position s and position t, counter-clockwise.
std::vector<Vec2> corners(const Box2& box, double s, double t) {
    const double w = box.hi.x - box.lo.x, h = box.hi.y - box.lo.y, all = 2 * (w + h);
    const std::array<std::pair<double, Vec2>, 4> each{
        {{0, box.lo}, {w, {box.hi.x, box.lo.y}}, {w + h, box.hi}, {2 * w + h, {box.lo.x, box.hi.y}}}};
    const double end = t >= s ? t : t + all;
    std::vector<Vec2> out;
    for (double round = 0; round <= all; round += all)
        for (const auto& [position, corner] : each)
            if (position + round > s && position + round < end) out.push_back(corner);
    return out;
}

// The places where the free straight ways from p along the axes leave the box.
std::vector<Vec2> outlets(const Box2& box, Vec3 p, const std::function<bool(Vec3, Vec3)>& free) {
    std::vector<Vec2> out;
    for (const Vec2 q : {Vec2{box.lo.x, p.y}, Vec2{box.hi.x, p.y}, Vec2{p.x, box.lo.y}, Vec2{p.x, box.hi.y}})
        if (free(p, {q.x, q.y, p.z})) out.push_back(q);
    return out;
}

} // namespace

std::optional<std::vector<Vec3>> around(const Box2& box, double margin, Vec3 from, Vec3 to,
                                        const std::function<bool(Vec3, Vec3)>& free,
                                        const std::function<bool(std::span<const Vec3>)>& clear) {
    const Box2 wide{box.lo - Vec2{margin, margin}, box.hi + Vec2{margin, margin}};
    const double all = 2 * (wide.hi.x - wide.lo.x + wide.hi.y - wide.lo.y);
    std::optional<std::vector<Vec3>> best;
    double shortest = 0;
    for (const Vec2 a : outlets(wide, from, free)) {
        for (const Vec2 b : outlets(wide, to, free)) {
            const double s = along(wide, a), t = along(wide, b), ahead = t >= s ? t - s : t - s + all;
            const double length =
                geom::distance(from.xy(), a) + std::min(ahead, all - ahead) + geom::distance(b, to.xy());
            if (best && length >= shortest) continue;
            auto turns = ahead <= all - ahead ? corners(wide, s, t) : corners(wide, t, s);
            if (ahead > all - ahead) std::reverse(turns.begin(), turns.end());
            std::vector<Vec3> way{from, {a.x, a.y, from.z}};
            const double outside = std::min(ahead, all - ahead);
            double gone = 0;
            for (const Vec2 c : turns) {
                gone += geom::distance(way.back().xy(), c);
                way.push_back({c.x, c.y, from.z + (to.z - from.z) * gone / outside});
            }
            if (const Vec3 last{b.x, b.y, to.z}; last != way.back()) way.push_back(last);
            way.push_back(to);
            if (!clear(way)) continue;
            shortest = length;
            best = std::move(way);
        }
    }
    return best;
}

} // namespace filum::link3d
