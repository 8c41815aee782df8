#include "fill/join/ring_graph.hpp"

#include "base/none.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::fill::join {

namespace {

std::vector<geom::Segment> segments_of(const rings::Rings& rings) {
    std::vector<geom::Segment> out;
    out.reserve(rings.points.size());
    for (std::uint32_t r = 0; r < rings.size(); ++r)
        for (std::uint32_t i = rings.start[r], end = rings.start[r + 1]; i < end; ++i) {
            const std::uint32_t after_last = rings.lane[r] == 0 ? i : rings.start[r];
            out.push_back({rings.points[i], rings.points[i + 1 == end ? after_last : i + 1]});
        }
    return out;
}

// The stretch of the axis u (unit, through the origin) that may lie within `reach` of the segment.
std::optional<Stretch> shadow(const geom::Segment& s, Vec2 u, double reach) {
    const double h0 = geom::cross(u, s.a), h1 = geom::cross(u, s.b);
    double lo = 0, hi = 1; // the part of the segment that is within reach of the axis
    if (h0 == h1) {
        if (std::abs(h0) > reach) return std::nullopt;
    } else {
        const double p = (-reach - h0) / (h1 - h0), q = (reach - h0) / (h1 - h0);
        lo = std::max(lo, std::min(p, q));
        hi = std::min(hi, std::max(p, q));
        if (lo > hi) return std::nullopt;
    }
    const double t0 = geom::dot(u, geom::lerp(s.a, s.b, lo)), t1 = geom::dot(u, geom::lerp(s.a, s.b, hi));
    return Stretch{std::min(t0, t1) - reach, std::max(t0, t1) + reach};
}

// Sorts the stretches, and joins those that overlap.
void merge(std::vector<Stretch>& v) {
    std::sort(v.begin(), v.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    std::size_t n = 0;
    for (const Stretch& s : v)
        if (n > 0 && s.from <= v[n - 1].to)
            v[n - 1].to = std::max(v[n - 1].to, s.to);
        else
            v[n++] = s;
    v.resize(n);
}

} // namespace

RingGraph::RingGraph(const rings::Rings& rings, double cell)
    : rings_(&rings), segments_(segments_of(rings)), grid_(segments_, geom::cell_for(segments_, cell)) {
    ring_of_.reserve(segments_.size());
    s_.reserve(segments_.size());
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
        double s = 0;
        for (std::uint32_t i = rings_->start[r]; i < rings_->start[r + 1]; ++i) {
            ring_of_.push_back(r);
            s_.push_back(s);
            s += geom::distance(segments_[i].a, segments_[i].b);
        }
        length_.push_back(s);
    }
}

std::vector<std::vector<Stretch>> RingGraph::near_others(double reach) const {
    constexpr double kSlack = 1e-6; // mm, more than what rounding can change
    reach += kSlack;
    const geom::SegmentGrid grid(segments_, geom::cell_for(segments_, reach), reach);
    std::vector<std::vector<Stretch>> out(size());
    std::vector<std::uint32_t> seen(segments_.size(), kNone); // the last segment that met it
    for (std::uint32_t i = 0; i < segments_.size(); ++i) {
        const std::uint32_t ring = ring_of_[i];
        const Vec2 a = segments_[i].a, b = segments_[i].b;
        const double length = geom::distance(a, b);
        if (length < 2 * reach) { // too short to be worth the search
            out[ring].push_back({s_[i], s_[i] + length});
            continue;
        }
        const Vec2 u = (1 / length) * (b - a);
        grid.along(a, b, [&](std::uint32_t j) {
            if (ring_of_[j] == ring || std::exchange(seen[j], i) == i) return;
            const auto part = shadow({segments_[j].a - a, segments_[j].b - a}, u, reach);
            if (part && part->to > 0 && part->from < length)
                out[ring].push_back({s_[i] + std::max(0.0, part->from), s_[i] + std::min(length, part->to)});
        });
    }
    for (auto& stretches : out) merge(stretches);
    return out;
}

double RingGraph::wrapped(std::uint32_t ring, double s) const {
    const double l = length_[ring];
    if (s >= 0 && s < l) return s;
    if (open(ring)) return std::clamp(s, 0.0, l);
    s = std::fmod(s, l);
    return s < 0 ? s + l : s;
}

std::uint32_t RingGraph::segment_at(std::uint32_t ring, double s) const {
    const auto first = s_.begin() + rings_->start[ring], last = s_.begin() + rings_->start[ring + 1];
    return static_cast<std::uint32_t>(std::upper_bound(first, last, s) - s_.begin() - 1);
}

std::pair<std::uint32_t, double> RingGraph::locate(std::uint32_t ring, double s) const {
    s = wrapped(ring, s);
    const std::uint32_t i = segment_at(ring, s);
    const double l = geom::distance(segments_[i].a, segments_[i].b);
    return {i, l > 0 ? std::min(1.0, (s - s_[i]) / l) : 0.0};
}

Vec2 RingGraph::at(std::uint32_t ring, double s) const {
    const auto [i, t] = locate(ring, s);
    return geom::lerp(segments_[i].a, segments_[i].b, t);
}

double RingGraph::width_of(std::pair<std::uint32_t, double> at) const {
    const std::uint32_t i = at.first, ring = ring_of_[i];
    const std::uint32_t next = i + 1 == rings_->start[ring + 1] ? rings_->start[ring] : i + 1;
    return (1 - at.second) * rings_->width[i] + at.second * rings_->width[next];
}

Place RingGraph::place_on(std::uint32_t segment, Vec2 p) const {
    const auto& seg = segments_[segment];
    const double t = geom::nearest_parameter(seg.a, seg.b, p);
    const Vec2 q = geom::lerp(seg.a, seg.b, t);
    return {ring_of_[segment], s_[segment] + t * geom::distance(seg.a, seg.b), q, geom::distance(p, q)};
}

void RingGraph::append(std::uint32_t ring, double s0, double s1, toolpath::Curve& to) const {
    const std::uint32_t first = rings_->start[ring], n = rings_->start[ring + 1] - first;
    const double from = wrapped(ring, s0), end = from + (s1 - s0);
    const double close = 1e-7; // mm: nearer points count as one
    to.add(at(ring, from), width_of(locate(ring, from)));
    for (std::uint32_t i = segment_at(ring, from) - first + 1; i <= 2 * n; ++i) {
        const double s = s_[first + i % n] + (i >= n ? length_[ring] : 0) + (i >= 2 * n ? length_[ring] : 0);
        if (s >= end - close) break;
        if (s > from + close) to.add(segments_[first + i % n].a, rings_->width[first + i % n]);
    }
    to.add(at(ring, end), width_of(locate(ring, end)));
}

} // namespace filum::fill::join
