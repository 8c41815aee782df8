#include "surface/trace.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string>

namespace filum::surface {

namespace {

constexpr double kInwards = 1e-7; // of the way to the triangle's middle: so no walk begins on a vertex or an edge

constexpr double kBeside = 1e-5; // of a side: how far from there the line itself crosses it

// A point of the surface, and beside it, a little inside of its triangle, the one that walks begin and end at.
struct Stop {
    std::uint32_t triangle;
    Vec3 point, inside;
};

// The nearest to `p`.
Stop place(const Surface& s, const Vec3& p, double& off) {
    const Segment at = nearest(s, p);
    off = std::max(off, distance(at.a, p));
    const auto& [a, b, c] = s.triangles[at.triangle];
    const Vec3 middle = 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
    return {at.triangle, at.a, at.a + kInwards * (middle - at.a)};
}

class Walk {
  public:
    Walk(const Surface& s, const Stop& from, const Stop& to) : surface_(s), from_(from), to_(to) {
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
    // How far along the side it crosses the plane; not bounded.
    [[nodiscard]] double part(std::uint32_t h, const Vec3& upright, const Vec3& on) const {
        const double u = dot(upright, surface_.vertices[surface_.tail(h)] - on);
        return u / (u - dot(upright, surface_.vertices[surface_.head(h)] - on));
    }
    [[nodiscard]] Vec3 on_side(std::uint32_t h, double part) const {
        const Vec3& a = surface_.vertices[surface_.tail(h)];
        return a + part * (surface_.vertices[surface_.head(h)] - a);
    }
    // Which sides are crossed, and where about, the points inside tell; where just, those meant, but of a side that
    // runs along the line.
    [[nodiscard]] Vec3 crossing(std::uint32_t h) const {
        const double about = part(h, upright_, from_.inside);
        const double just = std::clamp(part(h, exact_, from_.point), 0.0, 1.0);
        return on_side(h, std::abs(just - about) < kBeside ? just : about);
    }
    // The side that the plane leaves the triangle by; of two, in the first triangle, the one towards the end.
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
    const Stop &from_, &to_;
    Vec3 upright_, exact_; // normals of the plane through the points inside, through those meant
};

} // namespace

Trace trace(const Surface& s, std::span<const Vec3> points) {
    Trace out;
    Stop at = place(s, points[0], out.off);
    if (points.size() == 1) out.segments.push_back({at.triangle, at.point, at.point});
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Stop to = place(s, points[i], out.off);
        if (to.point == at.point) continue;
        if (!Walk(s, at, to).run(out.segments))
            throw Error(Exit::bad_input, "cannot draw a line on the surface: it ends between the points " +
                                             std::to_string(i) + " and " + std::to_string(i + 1) +
                                             "; put points closer together where it bends");
        at = to;
    }
    return out;
}

} // namespace filum::surface
