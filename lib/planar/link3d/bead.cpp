#include "link3d/bead.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <numeric>

namespace filum::link3d {

namespace {

void append(Bead& b, Vec2 p, double w, bool per_point) {
    if (!b.points.empty() && geom::distance(b.points.back(), p) < kSamePoint) return;
    b.points.push_back(p);
    if (per_point) b.width.push_back(w);
}

// Shortens the end of the bead by `gap` mm. If it would end within kCorner after a corner, it ends at the corner.
// Programs would round so short a piece onto the segment before it, and the next move could cross that.
void shorten(Bead& b, double gap) {
    const bool per_point = b.width.size() > 1;
    while (b.points.size() > 2) {
        const Vec2 last = b.points.back(), before = b.points[b.points.size() - 2];
        const double l = geom::distance(last, before);
        if (l > gap + kCorner) break;
        gap = std::max(0.0, gap - l);
        b.points.pop_back();
        if (per_point) b.width.pop_back();
    }
    const std::size_t n = b.points.size();
    const double l = geom::distance(b.points[n - 2], b.points[n - 1]), t = l > 0 ? std::min(gap / l, 1.0) : 0;
    b.points[n - 1] = geom::lerp(b.points[n - 1], b.points[n - 2], t);
    if (per_point) b.width[n - 1] += t * (b.width[n - 2] - b.width[n - 1]);
}

} // namespace

double mean_width(const toolpath::Curve& curve) {
    return std::accumulate(curve.width.begin(), curve.width.end(), 0.0) / static_cast<double>(curve.width.size());
}

Vec2 along(const toolpath::Curve& curve, const Place& place, double l) {
    const std::size_t n = curve.points.size();
    Vec2 at = place.point;
    for (std::size_t k = 1; k <= n; ++k) {
        if (!curve.closed && place.segment + k >= n) break;
        const Vec2 b = curve.points[(place.segment + k) % n];
        const double d = geom::distance(at, b);
        if (d > 0 && d >= l) return geom::lerp(at, b, l / d);
        l -= d;
        at = b;
    }
    return at;
}

double cut_gap(const toolpath::Curve& curve) {
    const double around = length(curve.points) + geom::distance(curve.points.back(), curve.points.front());
    constexpr double kRounded = 0.2146018366025517; // 1 - pi / 4
    return std::min(kRounded * mean_width(curve), around / 10);
}

Bead cut(const toolpath::Curve& curve, const Place& at, bool against, double gap) {
    const std::size_t n = curve.points.size();
    const bool per_point = curve.width.size() > 1;
    const std::size_t k = at.segment, next = (k + 1) % n;
    const double w = curve.width_at(k) + at.t * (curve.width_at(next) - curve.width_at(k));
    Bead b;
    b.points.reserve(n + 2);
    if (per_point) b.width.reserve(n + 2);
    append(b, at.point, w, per_point);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = against ? (k + n - i) % n : (next + i) % n;
        append(b, curve.points[j], curve.width_at(j), per_point);
    }
    append(b, at.point, w, per_point);
    if (b.points.size() < 2) {
        b.points.push_back(at.point);
        b.width.push_back(w);
    } // a curve of no length
    if (!per_point) b.width = {curve.width[0]};
    shorten(b, gap);
    return b;
}

Bead cut_over(const toolpath::Curve& curve, const Place& at, bool against, double over) {
    Bead b = cut(curve, at, against, 0);
    const std::size_t n = b.points.size();
    const bool per_point = b.width.size() > 1;
    for (std::size_t i = 0; i + 1 < n && over > kSamePoint; ++i) {
        const double l = geom::distance(b.points[i], b.points[i + 1]), t = l > over ? over / l : 1;
        const double w = per_point ? b.width[i] + t * (b.width[i + 1] - b.width[i]) : 0;
        append(b, geom::lerp(b.points[i], b.points[i + 1], t), w, per_point);
        over -= l;
    }
    return b;
}

Bead run(const toolpath::Curve& curve, bool against) {
    Bead b{curve.points, curve.width};
    if (against) {
        std::reverse(b.points.begin(), b.points.end());
        std::reverse(b.width.begin(), b.width.end());
    }
    return b;
}

void pin(Bead& bead, Vec2 p, double reach) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i)
        if (const double d = geom::point_segment_distance(bead.points[i], bead.points[i + 1], p); d < least) {
            least = d;
            best = i;
        }
    if (least > reach) return;
    for (const std::size_t i : {best, best + 1}) {
        if (geom::distance(bead.points[i], p) >= std::max(kCorner, least + kSamePoint)) continue;
        if (i > 0 && i + 1 < bead.points.size()) bead.points[i] = p;
        return;
    }
    const double t = geom::nearest_parameter(bead.points[best], bead.points[best + 1], p);
    const auto at = static_cast<std::ptrdiff_t>(best + 1);
    if (bead.width.size() > 1)
        bead.width.insert(bead.width.begin() + at, bead.width[best] + t * (bead.width[best + 1] - bead.width[best]));
    bead.points.insert(bead.points.begin() + at, p);
}

} // namespace filum::link3d
