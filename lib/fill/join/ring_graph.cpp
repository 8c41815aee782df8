#include "fill/join/ring_graph.hpp"

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

} // namespace

RingGraph::RingGraph(const rings::Rings& rings, double cell)
    : rings_(&rings), segments_(segments_of(rings)), grid_(segments_, cell) {
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

double RingGraph::wrapped(std::uint32_t ring, double s) const {
    const double l = length_[ring];
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
    const double close = 1e-7; // mm: no second point there
    to.add(at(ring, from), width_of(locate(ring, from)));
    for (std::uint32_t i = segment_at(ring, from) - first + 1; i <= 2 * n; ++i) {
        const double s = s_[first + i % n] + (i >= n ? length_[ring] : 0) + (i >= 2 * n ? length_[ring] : 0);
        if (s >= end - close) break;
        if (s > from + close) to.add(segments_[first + i % n].a, rings_->width[first + i % n]);
    }
    to.add(at(ring, end), width_of(locate(ring, end)));
}

} // namespace filum::fill::join
