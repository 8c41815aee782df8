#include "metrics/surface/rows.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::surface {

namespace {

using geodesic::Window;
using geom::Vec2;

constexpr double kGlue = 1e-7; // of a row: shorter gaps are closed

constexpr Interval kNothing{1, 0};

// Clips to c0 + c1 s >= 0.
void keep(Interval& p, double c0, double c1) {
    if (c1 > 0)
        p.lo = std::max(p.lo, -c0 / c1);
    else if (c1 < 0)
        p.hi = std::min(p.hi, -c0 / c1);
    else if (c0 < 0)
        p = kNothing;
}

// Clips to the points within `r` of `centre`, on a row from `a` with direction `d`. V: Vec2 or Vec3.
template <class V>
void keep_disc(Interval& p, const V& a, const V& d, const V& centre, double r) {
    const V f = a - centre;
    const double dd = dot(d, d), fd = dot(f, d), root = fd * fd - dd * (dot(f, f) - r * r);
    if (!(r > 0) || !(root >= 0) || !(dd > 0)) {
        p = kNothing;
        return;
    }
    const double half = std::sqrt(root);
    p.lo = std::max(p.lo, (-fd - half) / dd);
    p.hi = std::min(p.hi, (-fd + half) / dd);
}

Interval below_window(const Window& w, const Vec2& a, const Vec2& d, double level) {
    Interval p{0, 1};
    if (w.is_line()) {
        // between the rays through the window's ends, and before the front at `level`
        keep(p, w.sy * (a.x - w.b0) - w.sx * a.y, w.sy * d.x - w.sx * d.y);
        keep(p, w.sy * (w.b1 - a.x) + w.sx * a.y, w.sx * d.y - w.sy * d.x);
        keep(p, level - w.sigma - w.sx * a.x - w.sy * a.y, -(w.sx * d.x + w.sy * d.y));
        return p;
    }
    const Vec2 source{w.sx, w.sy}, f = a - source;
    const Vec2 left = Vec2{w.b0, 0} - source, right = Vec2{w.b1, 0} - source;
    keep(p, -cross(left, f), -cross(left, d));
    keep(p, cross(right, f), cross(right, d));
    keep_disc(p, a, d, source, level - w.sigma);
    return p;
}

} // namespace

Rows::Rows(const filum::surface::Surface& s, const geodesic::ExactField& field, std::uint32_t triangle, double level)
    : surface_(s), field_(field), triangle_(triangle), level_(level) {
    for (std::uint32_t k = 0; k < 3; ++k)
        for (std::uint32_t w = field.first[3 * triangle + k]; w != filum::surface::kNone; w = field.windows[w].next) {
            const Window& window = field.windows[w];
            const double nearest = window.is_line() ? std::min(window.at(window.b0), window.at(window.b1))
                                                    : window.at(std::clamp(window.sx, window.b0, window.b1));
            if (nearest < level) windows_.push_back({k, window});
        }
    const auto& own = field.segments;
    auto it = std::lower_bound(own.begin(), own.end(), triangle,
                               [](const filum::surface::Segment& a, std::uint32_t t) { return a.triangle < t; });
    for (; it != own.end() && it->triangle == triangle; ++it) segments_.push_back(*it);
}

void Rows::below(const Vec3& a, const Vec3& b, std::vector<Interval>& out) const {
    const auto add = [&](const Interval& p) {
        if (p.lo < p.hi) out.push_back(p);
    };
    Vec2 from[3], way[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t h = 3 * triangle_ + k, v = surface_.tail(h);
        from[k] = geodesic::flatten(surface_, field_.unfolding->frame[h], h, a);
        way[k] = geodesic::flatten(surface_, field_.unfolding->frame[h], h, b) - from[k];
        Interval p{0, 1};
        keep_disc(p, a, b - a, surface_.vertices[v], level_ - field_.distance[v]);
        add(p);
    }
    for (const SideWindow& s : windows_) add(below_window(s.window, from[s.side], way[s.side], level_));
    for (const filum::surface::Segment& s : segments_) {
        Interval disc{0, 1};
        keep_disc(disc, a, b - a, s.a, level_);
        add(disc);
        const Vec3 along = s.b - s.a;
        const double l2 = dot(along, along);
        if (!(l2 > 0)) continue;
        disc = {0, 1};
        keep_disc(disc, a, b - a, s.b, level_);
        add(disc);
        // between the ends, and at most `level` from the line
        const Vec3 d = b - a, n = 1 / std::sqrt(l2) * cross(filum::surface::normal(surface_, triangle_), along);
        Interval strip{0, 1};
        keep(strip, dot(a - s.a, along), dot(d, along));
        keep(strip, dot(s.b - a, along), -dot(d, along));
        keep(strip, level_ - dot(a - s.a, n), -dot(d, n));
        keep(strip, level_ + dot(a - s.a, n), dot(d, n));
        add(strip);
    }
}

void unite(std::vector<Interval>& parts) {
    std::sort(parts.begin(), parts.end(),
              [](const Interval& a, const Interval& b) { return a.lo != b.lo ? a.lo < b.lo : a.hi < b.hi; });
    std::size_t n = 0;
    for (const Interval& p : parts) {
        if (n > 0 && p.lo <= parts[n - 1].hi + kGlue)
            parts[n - 1].hi = std::max(parts[n - 1].hi, p.hi);
        else
            parts[n++] = p;
    }
    parts.resize(n);
}

double total(const std::vector<Interval>& united) {
    double sum = 0;
    for (const Interval& p : united) sum += p.hi - p.lo;
    return sum;
}

std::vector<Interval> common(const std::vector<Interval>& a, const std::vector<Interval>& b) {
    std::vector<Interval> out;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const Interval p{std::max(a[i].lo, b[j].lo), std::min(a[i].hi, b[j].hi)};
        if (p.lo < p.hi) out.push_back(p);
        if (a[i].hi < b[j].hi)
            ++i;
        else
            ++j;
    }
    return out;
}

} // namespace filum::metrics::surface
