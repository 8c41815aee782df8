#include "geodesic/window.hpp"

#include <utility>

namespace filum::geodesic {

namespace {

struct RootCollector {
    Crossings found;
    double lo, hi;
    void add(double x) {
        if (x > lo && x < hi && found.count < 2) found.x[found.count++] = x;
    }
};

// Adds the roots of a x^2 + 2 b x + c that satisfy `fits`; squaring may have introduced false ones.
template <class Fits>
void add_roots(RootCollector& out, double a, double b, double c, const Fits& fits) {
    const auto add = [&](double x) {
        if (fits(x)) out.add(x);
    };
    const double scale = std::abs(b) * std::max(std::abs(out.lo), std::abs(out.hi));
    if (std::abs(a) * std::max(out.lo * out.lo, out.hi * out.hi) <= 1e-14 * std::max(scale, std::abs(c))) {
        if (b != 0) add(-c / (2 * b));
        return;
    }
    const double disc = b * b - a * c;
    if (disc < 0) return;
    const double q = -(b + std::copysign(std::sqrt(disc), b)); // avoids cancellation
    const double r0 = q / a, r1 = q != 0 ? c / q : r0;
    add(std::min(r0, r1));
    if (r0 != r1) add(std::max(r0, r1));
}

} // namespace

namespace {

// The crossings if the interval starts at 0.
Crossings crossings_from(const Window& a, const Window& b, double lo, double hi) {
    RootCollector out{{}, lo, hi};
    if (a.is_line() && b.is_line()) {
        if (a.sx != b.sx) out.add((b.sigma - a.sigma) / (a.sx - b.sx));
    } else if (a.is_line() || b.is_line()) {
        const Window &line = a.is_line() ? a : b, &point = a.is_line() ? b : a;
        // |(x, 0) - s| = m + n x
        const double m = line.sigma - point.sigma, n = line.sx;
        add_roots(out, 1 - n * n, -point.sx - m * n, point.sx * point.sx + point.sy * point.sy - m * m,
                  [&](double x) { return m + n * x >= 0; });
    } else {
        // |x - s| = |x - t| + d, so 2 p x + r = 2 d |x - t|
        const double d = b.sigma - a.sigma, p = b.sx - a.sx;
        const double t2 = b.sx * b.sx + b.sy * b.sy;
        const double r = a.sx * a.sx + a.sy * a.sy - t2 - d * d;
        if (d == 0) {
            if (p != 0) out.add(-r / (2 * p));
        } else {
            add_roots(out, 4 * (p * p - d * d), 2 * (p * r + 2 * d * d * b.sx), r * r - 4 * d * d * t2,
                      [&](double x) { return (2 * p * x + r) * d >= 0; });
        }
    }
    return out.found;
}

// The window in coordinates that start at `x`.
Window seen_from(Window w, double x) {
    if (w.is_line())
        w.sigma += w.sx * x;
    else
        w.sx -= x;
    return w;
}

} // namespace

// In coordinates that start at `lo` rounding errors are relative to the interval, which matters where windows and
// sources are close together at the far end of an edge.
Crossings crossings(const Window& a, const Window& b, double lo, double hi) {
    Crossings out = crossings_from(seen_from(a, lo), seen_from(b, lo), 0, hi - lo);
    for (int i = 0; i < out.count; ++i) out.x[i] += lo;
    return out;
}

} // namespace filum::geodesic
