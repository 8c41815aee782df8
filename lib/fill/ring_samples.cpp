#include "fill/ring_samples.hpp"

#include "polygon/segments.hpp"

#include <algorithm>

namespace filum::fill {

namespace {

Rings resampled(const Rings& in, double step) {
    Rings out;
    out.level = in.level;
    for (std::size_t r = 0; r < in.loops.size(); ++r) {
        const auto loop = in.loops[r];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2 a = loop[i], b = loop[i + 1 == loop.size() ? 0 : i + 1];
            const int n = std::max(1, static_cast<int>(std::ceil(geom::distance(a, b) / step)));
            for (int k = 0; k < n; ++k) out.loops.points.push_back(geom::lerp(a, b, static_cast<double>(k) / n));
        }
        out.loops.close();
    }
    return out;
}

} // namespace

RingSamples::RingSamples(const Rings& rings, double step, double cell)
    : rings_(resampled(rings, step)), segments_(polygon::segments(rings_.loops)), grid_(segments_, cell) {
    const Loops& loops = rings_.loops;
    const std::size_t n = loops.points.size();
    ring_.resize(n), next_.resize(n), before_.resize(n), s_.resize(n);
    for (std::uint32_t r = 0; r < loops.size(); ++r) {
        double s = 0;
        for (std::uint32_t i = loops.start[r]; i < loops.start[r + 1]; ++i) {
            ring_[i] = r;
            s_[i] = s;
            s += geom::distance(segments_[i].a, segments_[i].b);
            next_[i] = i + 1 == loops.start[r + 1] ? loops.start[r] : i + 1;
            before_[next_[i]] = i;
        }
        length_.push_back(s);
    }
}

Normal RingSamples::normal(std::uint32_t i) const {
    const auto& u = segments_[before_[i]];
    const auto& v = segments_[i];
    const Vec2 a = u.b - u.a, b = v.b - v.a;
    const double la = geom::norm(a), lb = geom::norm(b);
    if (la == 0 && lb == 0) return {{0, 0}, 0};
    const Vec2 na = la > 0 ? (1 / la) * geom::left_of(a) : (1 / lb) * geom::left_of(b);
    const Vec2 nb = lb > 0 ? (1 / lb) * geom::left_of(b) : na;
    const Vec2 sum = na + nb;
    const double l = geom::norm(sum);
    if (l < 1e-9) return {na, 1};
    return {(1 / l) * sum, std::min(2.0, 2 / l)};
}

std::optional<Hit> RingSamples::hit(std::uint32_t i, Vec2 direction, double reach) const {
    return first_hit(grid_, segments_, point(i), direction, reach, i, before_[i]);
}

Normal RingSamples::side(std::uint32_t i) const {
    const Vec2 d = segments_[i].b - segments_[i].a;
    const double l = geom::norm(d);
    return l > 0 ? Normal{(1 / l) * geom::left_of(d), 1} : Normal{{0, 0}, 0};
}

double RingSamples::apart(std::uint32_t i, std::uint32_t j) const {
    const double d = std::abs(s_[i] - s_[j]);
    return std::min(d, length_[ring_[i]] - d);
}

double RingSamples::inner_radius(std::uint32_t i, Vec2 inward, double most, double blind) const {
    const Vec2 p = point(i), centre = p + most * inward;
    double radius = most;
    const auto touch = [&](Vec2 q) { // the disc through p and q with its centre on the normal
        const Vec2 d = q - p;
        const double h = geom::dot(d, inward);
        if (h > 0) radius = std::min(radius, geom::norm2(d) / (2 * h));
    };
    grid_.near({centre.x - most, centre.y - most}, {centre.x + most, centre.y + most}, [&](std::uint32_t j) {
        if (level(j) != level(i)) return;
        if (ring_[j] == ring_[i] && std::min(apart(i, j), apart(i, next_[j])) < blind) return;
        touch(segments_[j].a);
        touch(geom::nearest_point(segments_[j].a, segments_[j].b, p));
    });
    return radius;
}

std::optional<Hit> first_hit(const geom::SegmentGrid& grid, const std::vector<geom::Segment>& segments, Vec2 p, Vec2 d,
                             double reach, std::uint32_t skip_a, std::uint32_t skip_b) {
    std::optional<Hit> best;
    const Vec2 q = p + reach * d;
    grid.near({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}, [&](std::uint32_t i) {
        if (i == skip_a || i == skip_b) return;
        const auto at = geom::ray_parameters(p, d, segments[i].a, segments[i].b);
        if (!at || at->t > reach) return;
        if (!best || at->t < best->distance || (at->t == best->distance && i < best->segment))
            best = Hit{i, at->t, at->u};
    });
    return best;
}

} // namespace filum::fill
