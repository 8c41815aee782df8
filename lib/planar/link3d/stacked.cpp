#include "link3d/stacked.hpp"

#include "geom/polyline.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kOnLine = 0.002;     // mm; a point closer than this lies on the line
constexpr double kSameLength = 0.005; // mm; largest difference between a segment on a line and its stretch of the line

} // namespace

StackedWalls::StackedWalls(const std::vector<std::vector<Vec2>>& lines) : laid_(lines.size()) {
    for (const auto& line : lines) {
        lines_.push_back({false, line, {1}});
        along_.push_back(geom::arc_lengths(line));
    }
    if (!lines.empty()) index_.emplace(lines_);
}

StackedWalls::Pass StackedWalls::pass(Vec2 a, Vec2 b) {
    if (!index_) return Pass::plain;
    const auto p = index_->nearest(a, kOnLine), q = index_->nearest(b, kOnLine);
    if (!p || !q || p->curve != q->curve) return Pass::plain;
    const auto& sums = along_[p->curve];
    const auto at = [&](const Place& x) { return sums[x.segment] + x.t * (sums[x.segment + 1] - sums[x.segment]); };
    const auto [lo, hi] = std::minmax({at(*p), at(*q)});
    if (std::abs(hi - lo - geom::distance(a, b)) > kSameLength) return Pass::plain;
    auto& laid = laid_[p->curve];
    const double middle = (lo + hi) / 2;
    if (std::any_of(laid.begin(), laid.end(), [&](const auto& s) { return s.first <= middle && middle <= s.second; }))
        return Pass::upper;
    for (auto& s : laid) // the stretch usually continues one that is known
        if (std::abs(s.second - lo) < kSameLength || std::abs(s.first - hi) < kSameLength) {
            s = {std::min(s.first, lo), std::max(s.second, hi)};
            return Pass::lower;
        }
    laid.emplace_back(lo, hi);
    return Pass::lower;
}

SpatialBead StackedWalls::lay(const Bead& bead, double z, double height, double ramp) {
    SpatialBead out;
    const auto push = [&](Vec2 p, double width, Pass pass) {
        const bool half = pass != Pass::plain;
        out.points.push_back({p.x, p.y, pass == Pass::lower ? z - height / 2 : z});
        out.width.push_back(half ? 2 * width : width);
        out.height.push_back(half ? height / 2 : height);
    };
    const auto width = [&](std::size_t i) { return bead.width.size() == 1 ? bead.width[0] : bead.width[i]; };
    Pass now = Pass::plain;
    push(bead.points[0], width(0), now);
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i) {
        const Vec2 a = bead.points[i], b = bead.points[i + 1];
        const Pass next = pass(a, b);
        if (next != now) {
            const double l = geom::distance(a, b), t = l > 0 ? std::min(0.5, ramp / l) : 0.5;
            push(geom::lerp(a, b, t), width(i) + t * (width(i + 1) - width(i)), next);
        }
        now = next;
        push(b, width(i + 1), now);
    }
    return out;
}

} // namespace filum::link3d
