// Converts sources to first windows.
#include "geodesic/propagation.hpp"

namespace filum::geodesic {

namespace {

// Nearer points would leave angles between windows at the size of rounding errors.
constexpr double kOnIt = 1e-7; // longest sides of the triangle: a point nearer to a corner, or a side, is moved to it
constexpr double kLevelLine = 1e-9; // slope: a line that leaves a side flatter than this does not leave it

} // namespace

void Propagation::add_vertex(std::uint32_t vertex) {
    bends_[vertex] = 1;
    reach(vertex, 0);
}

// Adds the point at `x` on a side: windows along the side itself, for queries there, and through both triangles.
void Propagation::add_on_side(std::uint32_t h, double x) {
    for (const std::uint32_t side : {h, surface_.twin[h]}) {
        if (side == kNone) continue;
        const double at = side == h ? x : unfolding_->frame[h].length - x;
        const double cx = unfolding_->frame[side].cx, cy = unfolding_->frame[side].cy;
        // In the frame of `side`, as if the point were inside the triangle.
        const Frame& f = unfolding_->frame[side];
        const std::uint32_t hr = surface::next(side), hl = surface::prev(side);
        const Frame &fr = unfolding_->frame[hr], &fl = unfolding_->frame[hl];
        ExitSide right = exit_across(hr, false), left = exit_across(hl, true);
        right.third = left.third = kNone;
        const double rx = (f.length - cx) * fr.inverse_length, ry = -cy * fr.inverse_length;
        const double lx = cx * fl.inverse_length, ly = cy * fl.inverse_length;
        offer(right, 0, fr.length, (at - cx) * rx - cy * ry, -cy * rx - ry * (at - cx), 0, false);
        offer(left, 0, fl.length, at * lx, -ly * at, 0, false);
        ExitSide self = exit_across(side, false);
        self.third = kNone;
        offer(self, 0, f.length, f.length - at, 0, 0, false);
    }
}

void Propagation::add_point(std::uint32_t triangle, const Vec3& p) {
    double longest = 0;
    for (std::uint32_t k = 0; k < 3; ++k) longest = std::max(longest, unfolding_->frame[3 * triangle + k].length);
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t v = surface_.triangles[triangle][k];
        const double d = distance(surface_.vertices[v], p);
        if (d < kOnIt * longest) return add_vertex(v);
        reach(v, d);
    }
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const geom::Vec2 q = flatten(surface_, unfolding_->frame[h], h, p);
        if (q.y >= kOnIt * longest) continue;
        if (surface_.twin[h] != kNone) {
            const std::uint32_t far = surface_.tail(surface::prev(surface_.twin[h]));
            reach(far, distance(surface_.vertices[far], p));
        }
        return add_on_side(h, q.x);
    }
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        ExitSide exit = exit_across(h, false);
        exit.third = kNone;
        const geom::Vec2 q = flatten(surface_, unfolding_->frame[h], h, p);
        offer(exit, 0, exit.length, exit.length - q.x, -q.y, 0, false);
    }
}

// Adds windows from the interior of the segment, one across each side that faces it.
void Propagation::add_line(const Segment& s) {
    for (std::uint32_t h = 3 * s.triangle; h < 3 * s.triangle + 3; ++h) {
        ExitSide exit = exit_across(h, false);
        exit.third = kNone;
        const auto beyond = [&](const Vec3& p) { // in the frame of the triangle beyond
            const geom::Vec2 q = flatten(surface_, unfolding_->frame[h], h, p);
            return geom::Vec2{exit.length - q.x, std::min(0.0, -q.y)};
        };
        const geom::Vec2 a = beyond(s.a), b = beyond(s.b), along = b - a;
        geom::Vec2 n = 1 / norm(along) * geom::left_of(along);
        if (n.y < 0) n = -1 * n;
        if (!(n.y > kLevelLine)) continue;
        const double xa = a.x - a.y / n.y * n.x, xb = b.x - b.y / n.y * n.x;
        offer(exit, std::max(0.0, std::min(xa, xb)), std::min(exit.length, std::max(xa, xb)), n.x, n.y, -dot(n, a),
              true);
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t v = surface_.triangles[s.triangle][k];
        const Vec3 d = s.b - s.a;
        const double t = std::clamp(dot(surface_.vertices[v] - s.a, d) / dot(d, d), 0.0, 1.0);
        reach(v, distance(surface_.vertices[v], s.a + t * d));
    }
}

void Propagation::add(const Sources& sources) {
    for (const std::uint32_t v : sources.vertices) add_vertex(v);
    for (const Segment& s : sources.segments) {
        add_point(s.triangle, s.a);
        if (s.b == s.a) continue;
        add_point(s.triangle, s.b);
        add_line(s);
    }
    field_.segments = sources.segments;
    std::stable_sort(field_.segments.begin(), field_.segments.end(),
                     [](const Segment& a, const Segment& b) { return a.triangle < b.triangle; });
}

} // namespace filum::geodesic
