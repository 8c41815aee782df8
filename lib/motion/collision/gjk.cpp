#include "collision/gjk.hpp"

#include <limits>

namespace filum::collision {

namespace {

// The place of a point, segment or triangle nearest to the origin, and the corners that span it (C. Ericson, Real-Time
// Collision Detection, 2005, section 5.1).
struct NearestFeature {
    Vec3 at;
    double square = std::numeric_limits<double>::infinity();
    std::array<Vec3, 3> span{};
    std::size_t count = 0;
};

NearestFeature of(const Vec3& a) { return {a, dot(a, a), {a}, 1}; }

NearestFeature of(const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double t = -dot(a, d), l2 = dot(d, d);
    if (t <= 0) return of(a);
    if (t >= l2) return of(b);
    const Vec3 at = a + (t / l2) * d;
    return {at, dot(at, at), {a, b}, 2};
}

const NearestFeature& nearer(const NearestFeature& a, const NearestFeature& b) { return b.square < a.square ? b : a; }

NearestFeature of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const NearestFeature edge = nearer(nearer(of(a, b), of(b, c)), of(c, a));
    const Vec3 n = cross(b - a, c - a);
    const double n2 = dot(n, n);
    if (!(n2 > 0)) return edge;
    // The origin projects into the triangle if it is on the inner side of each edge.
    if (dot(cross(a, b), n) < 0 || dot(cross(b, c), n) < 0 || dot(cross(c, a), n) < 0) return edge;
    const Vec3 at = (dot(a, n) / n2) * n;
    return nearer(edge, {at, dot(at, at), {a, b, c}, 3});
}

// Whether the plane of a, b, c separates the origin from d; also if all are nearly coplanar.
bool parts(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 n = cross(b - a, c - a);
    const double origin = -dot(a, n), other = dot(d - a, n);
    return origin * other <= 0;
}

} // namespace

bool Simplex::holds(const Vec3& w) const {
    for (std::size_t i = 0; i < count_; ++i)
        if (point_[i] == w) return true;
    return false;
}

Vec3 Simplex::add(const Vec3& w) {
    point_[count_++] = w;
    const auto& [a, b, c, d] = point_;
    NearestFeature best;
    if (count_ == 1) best = of(a);
    if (count_ == 2) best = of(a, b);
    if (count_ == 3) best = of(a, b, c);
    if (count_ == 4) {
        bool outside = false;
        const auto face = [&](const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& other) {
            if (!parts(p, q, r, other)) return;
            outside = true;
            best = nearer(best, of(p, q, r));
        };
        face(a, b, c, d);
        face(a, b, d, c);
        face(a, c, d, b);
        face(b, c, d, a);
        if (!outside) return {};
    }
    count_ = best.count;
    for (std::size_t i = 0; i < count_; ++i) point_[i] = best.span[i];
    return best.at;
}

} // namespace filum::collision
