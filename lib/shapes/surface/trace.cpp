#include "surface/trace.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string>

namespace filum::surface {

namespace {

// share of the way to the triangle's middle by which walks start inside it, so that none starts on a vertex or edge
constexpr double kInwards = 1e-7;

constexpr double kBeside = 1e-5; // share of a side: how far the exact crossing may be from the approximate one

// A point of the surface, and a point beside it, slightly inside its triangle, where walks start and end.
struct WalkEnd {
    std::uint32_t triangle;
    Vec3 point, inside;
};

// The point of the surface nearest to `p`.
WalkEnd place(const Surface& s, const Vec3& p, double& off) {
    const Segment at = nearest(s, p);
    off = std::max(off, distance(at.a, p));
    const auto& [a, b, c] = s.triangles[at.triangle];
    const Vec3 middle = 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
    return {at.triangle, at.a, at.a + kInwards * (middle - at.a)};
}

class PlaneWalk {
  public:
    PlaneWalk(const Surface& s, const WalkEnd& from, const WalkEnd& to) : surface_(s), from_(from), to_(to) {
        const Vec3 n = normal(s, from.triangle) + normal(s, to.triangle);
        upright_ = cross(to.inside - from.inside, n);
        exact_ = cross(to.point - from.point, n);
    }

    // Appends the segments; false if the surface ends on the way.
    bool run(std::vector<Segment>& out) {
        if (!(norm(upright_) > 0)) return false;
        std::uint32_t t = from_.triangle, entry = kNone;
        Vec3 at = from_.point;
        for (std::size_t step = 0; step <= surface_.triangles.size(); ++step) {
            if (t == to_.triangle) {
                out.push_back({t, at, to_.point});
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
        return dot(upright_, surface_.vertices[vertex] - from_.inside);
    }
    [[nodiscard]] bool crosses(std::uint32_t h) const {
        return (height(surface_.tail(h)) < 0) != (height(surface_.head(h)) < 0);
    }
    // Parameter of the side's crossing with the plane, not limited to 0 to 1.
    [[nodiscard]] double part(std::uint32_t h, const Vec3& upright, const Vec3& on) const {
        const double u = dot(upright, surface_.vertices[surface_.tail(h)] - on);
        return u / (u - dot(upright, surface_.vertices[surface_.head(h)] - on));
    }
    [[nodiscard]] Vec3 on_side(std::uint32_t h, double part) const {
        const Vec3& a = surface_.vertices[surface_.tail(h)];
        return a + part * (surface_.vertices[surface_.head(h)] - a);
    }
    // The crossing with a side. The plane through the inside points decides which sides are crossed; the plane through
    // the exact points gives the position, except for a side almost along the line.
    [[nodiscard]] Vec3 crossing(std::uint32_t h) const {
        const double about = part(h, upright_, from_.inside);
        const double just = std::clamp(part(h, exact_, from_.point), 0.0, 1.0);
        return on_side(h, std::abs(just - about) < kBeside ? just : about);
    }
    // The side by which the plane leaves the triangle; in the first triangle, of two, the one towards the end.
    [[nodiscard]] std::uint32_t exit(std::uint32_t t, std::uint32_t entry) const {
        std::uint32_t best = kNone;
        double farthest = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            if (h == entry || !crosses(h)) continue;
            const double ahead =
                dot(on_side(h, part(h, upright_, from_.inside)) - from_.inside, to_.inside - from_.inside);
            if (best == kNone || ahead > farthest) {
                best = h;
                farthest = ahead;
            }
        }
        return best;
    }

    const Surface& surface_;
    const WalkEnd &from_, &to_;
    Vec3 upright_, exact_; // normals of the planes through the inside points and through the exact points
};

} // namespace

Trace trace(const Surface& s, std::span<const Vec3> points) {
    Trace out;
    WalkEnd at = place(s, points[0], out.off);
    if (points.size() == 1) out.segments.push_back({at.triangle, at.point, at.point});
    for (std::size_t i = 1; i < points.size(); ++i) {
        const WalkEnd to = place(s, points[i], out.off);
        if (to.point == at.point) continue;
        if (!PlaneWalk(s, at, to).run(out.segments))
            throw Error(Exit::bad_input, "cannot draw a line on the surface: it ends between the points " +
                                             std::to_string(i) + " and " + std::to_string(i + 1) +
                                             "; add points where the surface bends");
        at = to;
    }
    return out;
}

} // namespace filum::surface
