#include "metrics/planar/strips.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

constexpr double kNearlyParallel = 1e-3; // rad

bool has_ends(const SweptBead& bead, const Box2& box) {
    const Vec2 way = bead.upper - bead.lower;
    const double length2 = geom::norm2(way);
    for (const Vec2 p : {box.lo, box.hi, Vec2{box.lo.x, box.hi.y}, Vec2{box.hi.x, box.lo.y}}) {
        const double t = geom::dot(p - bead.lower, way);
        if (t < 0 || t > length2) return true;
    }
    return false;
}

// The frame of beads that pass a box: along the first of them, from end to end of the box.
Strips frame(const SweptBead& bead, const Box2& box) {
    Strips out;
    const Vec2 way = bead.upper - bead.lower;
    out.along = (1 / geom::norm(way)) * way;
    const Vec2 middle = geom::lerp(box.lo, box.hi, 0.5), half = box.hi - middle;
    const double reach = std::abs(out.along.x) * half.x + std::abs(out.along.y) * half.y;
    out.near = geom::dot(middle, out.along) - reach;
    out.far = out.near + 2 * reach;
    return out;
}

// The strip of a bead in this frame; nothing if it runs in another direction.
std::optional<Strip> strip_of(const SweptBead& b, const Strips& in) {
    const double length = geom::norm(b.upper - b.lower);
    Vec2 u = (1 / length) * (b.upper - b.lower);
    if (geom::dot(u, in.along) < 0) u = -1.0 * u; // level beads may run either way
    const double turn = geom::cross(in.along, u), ahead = geom::dot(in.along, u);
    if (std::abs(turn) > kNearlyParallel) return std::nullopt;
    const double t = geom::dot(b.lower, in.along), s = geom::dot(b.lower, geom::left_of(in.along));
    Strip out;
    for (const int end : {0, 1}) {
        const double at = s + turn / ahead * ((end == 0 ? in.near : in.far) - t);
        out.lo.at(end) = at - b.half / ahead;
        out.hi.at(end) = at + b.half / ahead;
    }
    return out;
}

} // namespace

std::optional<Strips> strips(std::span<const SweptBead> beads, const std::vector<std::uint32_t>& of, const Box2& box) {
    for (const std::uint32_t i : of)
        if (has_ends(beads[i], box)) return std::nullopt;
    Strips out = frame(beads[of.front()], box);
    for (const std::uint32_t i : of) {
        const auto strip = strip_of(beads[i], out);
        if (!strip) return std::nullopt;
        out.strip.push_back(*strip);
    }
    std::sort(out.strip.begin(), out.strip.end(), [](const Strip& a, const Strip& b) { return a.lo < b.lo; });
    for (std::size_t i = 0; i + 1 < out.strip.size(); ++i)
        for (const int end : {0, 1}) {
            const Strip &a = out.strip[i], &b = out.strip[i + 1];
            if (a.lo.at(end) > b.lo.at(end) || a.hi.at(end) > b.hi.at(end)) return std::nullopt;
        }
    return out;
}

bool side_by_side(const std::vector<Strip>& strip) {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i)
        for (const int end : {0, 1})
            if (strip[i].hi.at(end) > strip[i + 2].lo.at(end)) return false;
    return true;
}

bool merge(std::vector<Strip>& strip) {
    std::vector<Strip> out;
    for (const Strip& s : strip) {
        const auto meets = [&](int end) { return !out.empty() && s.lo.at(end) <= out.back().hi.at(end); };
        if (meets(0) != meets(1)) return false;
        if (meets(0))
            out.back().hi = s.hi;
        else
            out.push_back(s);
    }
    strip = std::move(out);
    return true;
}

Convex between(const Strips& all, const std::array<double, 2>& lower, const std::array<double, 2>& upper,
               const Box2& box) {
    const std::array<double, 2> open{upper[0] - lower[0], upper[1] - lower[1]};
    Convex out;
    if (open[0] <= 0 && open[1] <= 0) return out;
    const double meet = open[0] / (open[0] - open[1]); // if they meet
    const auto add = [&](int end, bool below) {
        if (open.at(end) > 0)
            out.add(all.point(end == 0 ? all.near : all.far, (below ? lower : upper).at(end)));
        else if (below) // one corner of a triangle
            out.add(all.point(std::lerp(all.near, all.far, meet), std::lerp(lower[0], lower[1], meet)));
    };
    add(0, true);
    add(1, true);
    add(1, false);
    add(0, false);
    return out.within(box);
}

} // namespace filum::metrics::planar
