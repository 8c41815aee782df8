// Lines of every kind to merge, and a judge that knows nothing of how they are merged.
#pragma once

#include "toolpath/merge.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace lines {

using filum::geom::Vec2;
using filum::geom::Vec3;
using filum::toolpath::Move;
using filum::toolpath::Span;

// The whole way that moves go, arcs as chords that leave them by at most `sagitta` mm.
inline std::vector<Vec3> way(const Vec3& begin, const std::vector<Move>& moves, double sagitta) {
    std::vector<Vec3> out{begin};
    for (const Move& m : moves) {
        const Vec3 from = out.back();
        const Vec2 arm = from.xy() - m.centre;
        const double radius = norm(arm);
        const int n =
            m.sweep == 0
                ? 1
                : 1 + static_cast<int>(std::abs(m.sweep) / (2 * std::acos(1 - std::min(1.0, sagitta / radius))));
        for (int k = 1; k < n; ++k) {
            const double a = m.sweep * k / n, c = std::cos(a), s = std::sin(a);
            const Vec2 p = m.centre + Vec2{c * arm.x - s * arm.y, s * arm.x + c * arm.y};
            out.push_back({p.x, p.y, from.z + (m.to.z - from.z) * k / n});
        }
        out.push_back(m.to);
    }
    return out;
}

// The part of the segment a b, in [0, 1], that is within `most` of p; empty if the first is above the second.
struct Part {
    double low = 1, high = 0;
};
inline Part within(const Vec3& a, const Vec3& b, const Vec3& p, double most) {
    const Vec3 d = b - a, f = a - p;
    const double A = dot(d, d), B = dot(f, d), C = dot(f, f) - most * most;
    if (!(A > 0)) return C <= 0 ? Part{0, 1} : Part{};
    const double D = B * B - A * C;
    if (D < 0) return {};
    return {std::max(0.0, (-B - std::sqrt(D)) / A), std::min(1.0, (-B + std::sqrt(D)) / A)};
}

// Whether the Fréchet distance between two lines is at most `most`: the free-space diagram of Alt and Godau (1995).
inline bool follows(const std::vector<Vec3>& p, const std::vector<Vec3>& q, double most) {
    const std::size_t n = p.size(), m = q.size();
    if (distance(p[0], q[0]) > most || distance(p[n - 1], q[m - 1]) > most) return false;
    // What can be reached of the left border of cell (i, j), at point i of p, and of its bottom, at point j of q.
    std::vector<Part> left(m - 1), bottom(m);
    for (std::size_t j = 0; j + 1 < m; ++j) { // along q while p waits at its first point
        const Part free = within(q[j], q[j + 1], p[0], most);
        const bool on = j == 0 || left[j - 1].high >= 1;
        left[j] = on && free.low <= 0 ? free : Part{};
    }
    for (std::size_t i = 0; i + 1 < n; ++i) {
        std::vector<Part> right(m - 1), top(m);
        const Part begin = within(p[i], p[i + 1], q[0], most);
        bottom[0] = begin.low <= 0 && (i == 0 || bottom[0].high >= 1) ? begin : Part{};
        for (std::size_t j = 0; j + 1 < m; ++j) {
            const Part r = within(q[j], q[j + 1], p[i + 1], most), t = within(p[i], p[i + 1], q[j + 1], most);
            const bool from_left = left[j].low <= left[j].high, from_bottom = bottom[j].low <= bottom[j].high;
            if (from_bottom)
                right[j] = r;
            else if (from_left)
                right[j] = {std::max(r.low, left[j].low), r.high};
            if (from_left)
                top[j + 1] = t;
            else if (from_bottom)
                top[j + 1] = {std::max(t.low, bottom[j].low), t.high};
            if (j + 2 < m) bottom[j + 1] = top[j + 1];
        }
        if (i + 2 == n) return right[m - 2].low <= right[m - 2].high && right[m - 2].high >= 1;
        left = right;
        for (std::size_t j = 1; j < m; ++j) bottom[j] = top[j];
    }
    return true;
}

// A line of one of many kinds.
inline Span random_line(std::mt19937& random) {
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto whole = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(random); };
    Span s;
    const int kind = whole(0, 7), n = whole(2, 160);
    Vec3 at{uniform(-50, 50), uniform(-50, 50), 0.2};
    double heading = uniform(0, 6.3);
    const double step = std::exp(uniform(std::log(5e-4), std::log(3.0))), radius = std::exp(uniform(-2, 4));
    const double width = uniform(0.1, 0.9), swing = whole(0, 1) == 0 ? 0 : uniform(0, 0.6);
    for (int k = 0; k < n; ++k) {
        s.points.push_back(at);
        s.width.push_back(width * (1 + swing * std::sin(k * 0.3)));
        double by = step * (whole(0, 3) == 0 ? uniform(0, 1) : 1), turn = 0;
        switch (kind) {
        case 0: // a circle, perhaps many times round
            turn = by / radius;
            break;
        case 1: // corners
            turn = whole(0, 9) == 0 ? uniform(-3.14, 3.14) : 0;
            break;
        case 2: // there and back
            turn = whole(0, 9) == 0 ? std::numbers::pi : 0;
            break;
        case 3: // shaking
            turn = uniform(-0.4, 0.4);
            break;
        case 4: // waves
            turn = 0.3 * std::sin(k * 0.15);
            break;
        case 5: // on the spot, often
            by *= whole(0, 2) == 0 ? 0 : 1;
            turn = uniform(-0.1, 0.1);
            break;
        case 6: // a ramp, round and round
            turn = by / radius;
            at.z += whole(0, 20) == 0 ? 0.05 : 0.001;
            break;
        default: // anywhere
            turn = uniform(-3.14, 3.14);
            break;
        }
        heading += turn;
        at.x += by * std::cos(heading);
        at.y += by * std::sin(heading);
    }
    s.height = {0.2};
    return s;
}

} // namespace lines
