#include "polygon/circles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::polygon {

namespace {

constexpr long double kRounding = std::numeric_limits<long double>::epsilon() / 2; // relative error of one operation
constexpr long double kNever = std::numeric_limits<long double>::infinity();
constexpr long double kMay = kCirclePlaces * std::numeric_limits<double>::epsilon();

struct Direction {
    std::int64_t x, y;

    [[nodiscard]] long double length() const { // squares below 2^60 and their sum are exact
        return std::sqrt(static_cast<long double>(x) * x + static_cast<long double>(y) * y);
    }
};

Direction operator-(SitePoint a, SitePoint b) { return {a.x - b.x, a.y - b.y}; }
std::int64_t cross(Direction a, Direction b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(Direction a, Direction b) { return a.x * b.x + a.y * b.y; }

// The circle with centre (x, y) and greatest x `right`, relative to `from`, each off by at most `off`. Nothing if that
// is too much.
std::optional<SiteCircle> checked(SitePoint from, long double x, long double y, long double right, long double off) {
    x += from.x;
    y += from.y;
    right += from.x;
    if (!(off <= kMay * std::min({std::abs(x), std::abs(y), std::abs(right)}))) return std::nullopt;
    return SiteCircle{static_cast<double>(x), static_cast<double>(y), static_cast<double>(right)};
}

// How a direction turns into another one, each number without cancellation.
struct Turn {
    long double x, y;  // by which the unit vector changes
    long double sine;  // of the angle
    long double half2; // the square of the sine of half the angle

    [[nodiscard]] long double most() const { return std::abs(x) + std::abs(y); } // no less than the sine
};
Turn turn(Direction a, long double a_length, Direction b, long double b_length) {
    const long double lengths = a_length * b_length, along = dot(a, b), across = cross(a, b);
    const long double ax = a.x / a_length, ay = a.y / a_length, bx = b.x / b_length, by = b.y / b_length;
    if (along <= 0) return {bx - ax, by - ay, across / lengths, (1 - along / lengths) / 2};
    const long double half = across / (lengths + along); // tangent of half the angle
    return {-half * (ay + by), half * (ax + bx), across / lengths, half * across / (2 * lengths)};
}

// A place along a line, in units of the line's direction; off by at most `off` roundings.
struct Root {
    long double at, off;
};

// A root of g2 * s * s - 2 * a * s + n. Here b * b = a * a - g2 * n, and n is off by `n_off` roundings.
Root root(long double a, long double b, long double g2, long double n, long double n_off) {
    const bool cancel = (a < 0) != (b < 0);
    const long double at = cancel ? n / (a - b) : (a + b) / g2;
    return {at, 8 * std::abs(at) + (cancel ? n_off / std::abs(a - b) : 0)};
}

// The circle through p with centre p + t * u + s * left(u); t is off by `t_off` roundings.
struct Bisector {
    long double x, y, length; // the vector u and its length
};
std::optional<SiteCircle> on_line(SitePoint p, long double t, long double t_off, Root s, const Bisector& u) {
    const long double x = t * u.x - s.at * u.y, y = t * u.y + s.at * u.x, r = std::sqrt(x * x + y * y);
    return checked(p, x, y, x + r, 2 * kRounding * (u.length * (t_off + s.off) + 8 * r));
}

} // namespace

// Solves n_i * centre + d_i = r by Cramer's rule, with unit normals n_i and distances d_i from one end of b. Nothing
// cancels in the determinant, the sum of the sines of three angles that add up to a multiple of a full turn: it is 4
// times the product of the sines of half the angles.
std::optional<SiteCircle> touching_circle(const SiteLine& a, const SiteLine& b, const SiteLine& c) {
    constexpr long double kOps = 64 * kRounding; // roundings of a term and of the sum of two, with a reserve
    const SitePoint o = b.from;
    const Direction u = a.to - a.from, v = b.to - b.from, w = c.to - c.from;
    const long double lu = u.length(), lv = v.length(), lw = w.length();
    const Turn uv = turn(u, lu, v, lv), vw = turn(v, lv, w, lw), wu = turn(w, lw, u, lu);
    const long double size = 4 * std::sqrt(uv.half2 * vw.half2 * wu.half2);
    if (!(size > 0)) return std::nullopt;
    // two or all three of the sines have the sign of their sum, and so has the middle one
    const long double low = std::min(uv.sine, vw.sine), high = std::max(uv.sine, vw.sine);
    const long double det = std::clamp(wu.sine, low, high) > 0 ? size : -size;
    const long double du = cross(a.from - o, a.to - o) / lu, dw = cross(c.from - o, c.to - o) / lw; // that of b is 0
    const long double x = (vw.x * du + uv.x * dw) / det, y = (vw.y * du + uv.y * dw) / det;
    const long double r = -(vw.sine * du + uv.sine * dw) / det;
    return checked(o, x, y, x + r, kOps * (vw.most() * std::abs(du) + uv.most() * std::abs(dw)) / size);
}

// Takes p as the origin. Let n and m be the unit normals of the lines towards the circle, d and e the distances of p
// from them. Then centre * (n - m) = e - d, so the centre lies on a line along the bisector. Also |centre| = n * centre
// + d. This leaves a quadratic equation whose discriminant is a product.
std::optional<SiteCircle> touching_circle(SitePoint p, const SiteLine& one, const SiteLine& two, bool farther) {
    const Direction v = one.to - one.from, w = two.to - two.from;
    const std::int64_t left = cross(v, p - one.from), right = -cross(w, p - two.from);
    if ((left < 0 && right > 0) || (left > 0 && right < 0)) return std::nullopt;
    const bool turned = left < 0 || right < 0; // p is right of one and left of two
    const long double lv = v.length(), lw = w.length(), lengths = lv * lw, along = dot(v, w), across = cross(v, w);
    if (left == 0 && right == 0) return checked(p, 0, 0, 0, across != 0 ? 0 : kNever);
    const long double d = std::abs(left) / lv, e = std::abs(right) / lw, mean = (d + e) / 2, more = e - d;
    const bool narrow = along < 0; // the normals are less than a right angle apart
    // 1 minus the cosine of the angle between the normals, and their cross product.
    const long double q = narrow ? across / lengths * (across / (lengths - along)) : 1 + along / lengths;
    const long double k = -across / lengths;
    if (!(q > 0)) return std::nullopt;
    const long double a = more * more / (2 * q), b = mean * mean;
    const Root s = root(mean * k, (farther == turned ? 1 : -1) * std::sqrt(2 * q * d * e), q * q, a - b,
                        8 * (a + b) + 4 * mean * std::abs(more) / q);

    const long double sign = turned ? -1 : 1, vx = v.x / lv, vy = v.y / lv, wx = w.x / lw, wy = w.y / lw;
    long double x = -sign * (vy + wy), y = sign * (vx + wx), length = std::sqrt(2 * q); // n - m
    if (narrow) {
        const long double half = sign * k / (2 - q); // tangent of half the angle between the normals
        x = half * (vx - wx);
        y = half * (vy - wy);
    }
    return on_line(p, more / (2 * q), 4 * mean / (2 * q), s, {x, y, length});
}

// Solves the same equation with q as the other point: the centre lies on the bisector of p and q.
std::optional<SiteCircle> touching_circle(SitePoint p, SitePoint q, const SiteLine& line, bool left) {
    const Direction w = q - p, v = line.to - line.from;
    const std::int64_t at_p = cross(v, p - line.from), at_q = cross(v, q - line.from);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0) || (at_p == 0 && at_q == 0)) return std::nullopt;
    const long double lv = v.length(), lw = w.length(), sign = at_p < 0 || at_q < 0 ? -1 : 1;
    const long double d = std::abs(at_p) / lv, e = std::abs(at_q) / lv, mean = (d + e) / 2;
    const long double g = cross(v, w) / lv, a = lw * lw / 4, b = mean * mean, slope = mean * sign * dot(v, w) / lv;
    const Root s = root(slope, g == 0 ? -slope : (left ? 1 : -1) * lw * std::sqrt(d * e), g * g, a - b, 8 * (a + b));
    return on_line(p, 0.5L, 0, s, {static_cast<long double>(w.x), static_cast<long double>(w.y), lw});
}

} // namespace filum::polygon
