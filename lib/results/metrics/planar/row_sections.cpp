#include "metrics/planar/row_sections.hpp"

#include <algorithm>
#include <cmath>

namespace filum::metrics::planar {

namespace {

// Restricts [lo, hi] to the x with from <= x * slope + offset <= to.
void clip(double& lo, double& hi, double slope, double offset, double from, double to) {
    if (slope == 0) {
        if (offset < from || offset > to) hi = lo - 1;
        return;
    }
    const double p = (from - offset) / slope, q = (to - offset) / slope;
    lo = std::max(lo, std::min(p, q));
    hi = std::min(hi, std::max(p, q));
}

} // namespace

bool section(const SweptBead& l, double y, Interval& out) {
    double lo = INFINITY, hi = -INFINITY;
    for (const Vec2 c : {l.a, l.b}) {
        const double d2 = l.half * l.half - (y - c.y) * (y - c.y);
        if (d2 < 0) continue;
        const double d = std::sqrt(d2);
        lo = std::min(lo, c.x - d);
        hi = std::max(hi, c.x + d);
    }
    const double dy = y - l.a.y;
    double from = -l.length - l.half, to = l.length + l.half; // x - a.x on the straight part
    clip(from, to, -l.u.y, dy * l.u.x, -l.half, l.half);
    clip(from, to, l.u.x, dy * l.u.y, 0, l.length);
    if (from <= to) {
        lo = std::min(lo, l.a.x + from);
        hi = std::max(hi, l.a.x + to);
    }
    out = {lo, hi, l.slot};
    return lo < hi;
}

std::vector<SweptBead> swept_beads(std::span<const Bead> beads) {
    std::vector<SweptBead> out;
    out.reserve(beads.size());
    for (const Bead& b : beads) {
        SweptBead l{b.a, b.b, {1, 0}, b.width / 2, geom::distance(b.a, b.b), 0, 0, b.slot};
        if (l.length > 0) l.u = (1 / l.length) * (b.b - b.a);
        l.lo = std::min(b.a.y, b.b.y) - l.half;
        l.hi = std::max(b.a.y, b.b.y) + l.half;
        out.push_back(l);
    }
    std::sort(out.begin(), out.end(), [](const SweptBead& p, const SweptBead& q) { return p.lo < q.lo; });
    return out;
}

void unite(std::vector<Interval>& v) {
    std::sort(v.begin(), v.end(),
              [](const Interval& p, const Interval& q) { return p.slot != q.slot ? p.slot < q.slot : p.lo < q.lo; });
    std::vector<Interval> out;
    for (const Interval& i : v) add_united(i, out);
    v = std::move(out);
}

} // namespace filum::metrics::planar
