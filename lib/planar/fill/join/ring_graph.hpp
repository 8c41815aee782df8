// Rings with arc lengths and a grid: finds the places of rings near a point. Private to lib/planar/fill.
#pragma once

#include "fill/rings/rings.hpp"
#include "geom/segment_grid.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace filum::fill::join {

using geom::Vec2;
using polygon::Loops;

// A place on a ring: arc length from its first point.
struct Place {
    std::uint32_t ring = 0;
    double s = 0;
    Vec2 point;
    double distance = 0; // mm from the point or ray origin of the query
};

// A stretch of a ring, in arc lengths.
struct Stretch {
    double from = 0, to = 0;
};

// Refers to the rings, which must outlive it.
class RingGraph {
  public:
    // `cell`: mm, the least cell size of the grid.
    RingGraph(const rings::Rings& rings, double cell);

    [[nodiscard]] std::size_t size() const { return length_.size(); }
    [[nodiscard]] bool open(std::uint32_t ring) const { return rings_->lane[ring] == 0; } // a line with two ends
    [[nodiscard]] double length(std::uint32_t ring) const { return length_[ring]; }
    [[nodiscard]] std::uint32_t points(std::uint32_t ring) const {
        return rings_->start[ring + 1] - rings_->start[ring];
    }
    [[nodiscard]] Vec2 at(std::uint32_t ring, double s) const; // s wraps around rings; open lines clamp it
    [[nodiscard]] double width(std::uint32_t ring, double s) const { return width_of(locate(ring, s)); }

    // The nearest place to p within `reach` on a ring for which use(ring) holds. Ties: the lower segment.
    template <class Use>
    [[nodiscard]] std::optional<Place> nearest(Vec2 p, double reach, Use&& use) const {
        double best = reach * reach;
        std::optional<std::uint32_t> found;
        grid_.near({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}, [&](std::uint32_t i) {
            if (!use(ring_of_[i])) return;
            const double d = geom::norm2(geom::nearest_point(segments_[i].a, segments_[i].b, p) - p);
            if (d < best || (found && d == best && i < *found)) {
                best = d;
                found = i;
            }
        });
        if (!found) return std::nullopt;
        return place_on(*found, p);
    }

    // The first place where the ray from p along d (unit) meets a ring for which use(ring) holds. The distance from p
    // is at least `from` and at most `reach`, mm.
    template <class Use>
    [[nodiscard]] std::optional<Place> first_hit(Vec2 p, Vec2 d, double from, double reach, Use&& use) const {
        std::optional<Place> best;
        const Vec2 q = p + reach * d;
        grid_.near({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)},
                   [&](std::uint32_t i) {
                       if (!use(ring_of_[i])) return;
                       const auto& [a, b] = segments_[i];
                       const auto at = geom::ray_parameters(p, d, a, b);
                       if (!at || at->t < from || at->t > reach || (best && at->t >= best->distance)) return;
                       best = Place{ring_of_[i], s_[i] + at->u * geom::distance(a, b), geom::lerp(a, b, at->u), at->t};
                   });
        return best;
    }

    // For each ring the stretches on which another ring may lie within `reach`, ascending. They include all such places
    // and some others. The cost depends on the number of segments and of neighbours, so long rows far apart cost
    // little.
    [[nodiscard]] std::vector<std::vector<Stretch>> near_others(double reach) const;

    // True if the open segment p-q crosses any ring.
    [[nodiscard]] bool crosses(Vec2 p, Vec2 q) const {
        return grid_.crosses(p, q, segments_, [](std::uint32_t) { return true; });
    }

    // Calls f(place) where the open segment p-q crosses a ring. A crossing may be reported more than once.
    template <class F>
    void each_crossing(Vec2 p, Vec2 q, F&& f) const {
        grid_.near({std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)},
                   [&](std::uint32_t i) {
                       const auto& [a, b] = segments_[i];
                       if (!geom::cross_properly(p, q, a, b)) return;
                       const double u = geom::orient(p, q, a), v = geom::orient(p, q, b), t = u / (u - v);
                       f(Place{ring_of_[i], s_[i] + t * geom::distance(a, b), geom::lerp(a, b, t), 0});
                   });
    }

    // Appends the points of the ring from s0 to s1 > s0, both ends included, and their widths.
    void append(std::uint32_t ring, double s0, double s1, toolpath::Curve& to) const;

  private:
    [[nodiscard]] Place place_on(std::uint32_t segment, Vec2 nearest_to) const;
    // The segment at arc length s and the parameter on it.
    [[nodiscard]] std::pair<std::uint32_t, double> locate(std::uint32_t ring, double s) const;
    [[nodiscard]] double width_of(std::pair<std::uint32_t, double> at) const;
    [[nodiscard]] std::uint32_t segment_at(std::uint32_t ring, double s) const;
    [[nodiscard]] double wrapped(std::uint32_t ring, double s) const;

    const rings::Rings* rings_;
    std::vector<geom::Segment> segments_; // from each point to the next; the last point of an open line to itself
    std::vector<std::uint32_t> ring_of_;  // per segment
    std::vector<double> s_, length_;      // arc length at the start of each segment; length of each ring
    geom::SegmentGrid grid_;
};

} // namespace filum::fill::join
