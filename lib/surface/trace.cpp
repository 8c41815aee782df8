#include "surface/trace.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string>

namespace filum::surface {

namespace {

constexpr double kInwards = 1e-7; // of the way to the triangle's middle: so no point lies on a vertex or an edge

// The nearest point, a little inside of its triangle.
Segment place(const Surface& s, const Vec3& p, double& off) {
    Segment out = nearest(s, p);
    off = std::max(off, distance(out.a, p));
    const auto& [a, b, c] = s.triangles[out.triangle];
    const Vec3 middle = 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
    out.a = out.b = out.a + kInwards * (middle - out.a);
    return out;
}

class Walk {
  public:
    Walk(const Surface& s, const Segment& from, const Segment& to) : surface_(s), from_(from), to_(to) {
        upright_ = cross(to.a - from.a, normal(s, from.triangle) + normal(s, to.triangle));
    }

    // Appends the segments; false if the surface ends on the way.
    bool run(std::vector<Segment>& out) {
        if (!(norm(upright_) > 0)) return false;
        std::uint32_t t = from_.triangle, entry = kNone;
        Vec3 at = from_.a;
        for (std::size_t step = 0; step <= surface_.triangles.size(); ++step) {
            if (t == to_.triangle) {
                out.push_back({t, at, to_.a});
                return true;
            }
            const std::uint32_t side = exit(t, entry);
            if (side == kNone) return false;
            const Vec3 next = crossing(side);
            out.push_back({t, at, next});
            at = next;
            entry = surface_.twin[side];
            if (entry == kNone) return false;
            t = entry / 3;
        }
        return false;
    }

  private:
    [[nodiscard]] double height(std::uint32_t vertex) const {
        return dot(upright_, surface_.vertices[vertex] - from_.a);
    }
    [[nodiscard]] bool crosses(std::uint32_t h) const {
        return (height(surface_.tail(h)) < 0) != (height(surface_.head(h)) < 0);
    }
    [[nodiscard]] Vec3 crossing(std::uint32_t h) const {
        const Vec3 &a = surface_.vertices[surface_.tail(h)], &b = surface_.vertices[surface_.head(h)];
        const double u = height(surface_.tail(h)), v = height(surface_.head(h));
        return a + u / (u - v) * (b - a);
    }
    // The side that the plane leaves the triangle by; of two, in the first triangle, the one towards the end.
    [[nodiscard]] std::uint32_t exit(std::uint32_t t, std::uint32_t entry) const {
        std::uint32_t best = kNone;
        double farthest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            if (h == entry || !crosses(h)) continue;
            const double ahead = dot(crossing(h) - from_.a, to_.a - from_.a);
            if (best == kNone || ahead > farthest) best = h, farthest = ahead;
        }
        return best;
    }

    const Surface& surface_;
    const Segment &from_, &to_;
    Vec3 upright_; // normal of the plane
};

} // namespace

Trace trace(const Surface& s, std::span<const Vec3> points) {
    Trace out;
    Segment at = place(s, points[0], out.off);
    if (points.size() == 1) out.segments.push_back(at);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Segment to = place(s, points[i], out.off);
        if (to.triangle == at.triangle && to.a == at.a) continue;
        if (!Walk(s, at, to).run(out.segments))
            throw Error(Exit::bad_input, "cannot draw a line on the surface: it ends between the points " +
                                             std::to_string(i) + " and " + std::to_string(i + 1) +
                                             "; put points closer together where it bends");
        at = to;
    }
    return out;
}

} // namespace filum::surface
