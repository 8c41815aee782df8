// Rings sampled closely enough to measure the space around them.  Private to lib/fill.
#pragma once

#include "fill/rings.hpp"
#include "geom/segment_grid.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::fill {

struct Normal {
    Vec2 inward;  // unit, to the left: into the solid
    double mitre; // how much farther a corner moves than its sides, at most 2; 0 where there is no direction
};

struct Hit {
    std::uint32_t segment;
    double distance, along; // along: parameter on the segment
};

// Sample i is points[i]; segment i runs from it to sample next[i].
class RingSamples {
  public:
    // `rings` with points added so that none are farther apart than `step`.
    RingSamples(const Rings& rings, double step, double cell);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(rings_.loops.points.size()); }
    [[nodiscard]] const Rings& rings() const { return rings_; }
    [[nodiscard]] Vec2 point(std::uint32_t i) const { return rings_.loops.points[i]; }
    [[nodiscard]] int level(std::uint32_t i) const { return rings_.level[ring_[i]]; }
    [[nodiscard]] std::uint32_t next(std::uint32_t i) const { return next_[i]; }
    [[nodiscard]] std::uint32_t before(std::uint32_t i) const { return before_[i]; }
    [[nodiscard]] Normal normal(std::uint32_t i) const; // at sample i, between its two segments
    [[nodiscard]] Normal side(std::uint32_t i) const;   // of segment i

    // The first segment hit from sample i along `direction` (unit) within `reach`, but for the two that end there.
    [[nodiscard]] std::optional<Hit> hit(std::uint32_t i, Vec2 direction, double reach) const;

    // Radius, at most `most`, of the largest disc that touches sample i on its inner side and holds no point of a ring
    // of the same level: the distance to the medial axis.  The ring's own points within `blind` of i along it do not
    // count, or every bend would be the end of a wall.
    [[nodiscard]] double inner_radius(std::uint32_t i, Vec2 inward, double most, double blind) const;

  private:
    [[nodiscard]] double apart(std::uint32_t i, std::uint32_t j) const; // arc length along the ring

    Rings rings_;
    std::vector<std::uint32_t> ring_, next_, before_;
    std::vector<double> s_, length_; // arc length per sample; per ring
    std::vector<geom::Segment> segments_;
    geom::SegmentGrid grid_;
};

// The nearest crossing of the ray from p along d (unit) with `segments`, within `reach`; segments skip_a and skip_b do
// not count.  Ties: the lower segment.
std::optional<Hit> first_hit(const geom::SegmentGrid& grid, const std::vector<geom::Segment>& segments, Vec2 p, Vec2 d,
                             double reach, std::uint32_t skip_a, std::uint32_t skip_b);

} // namespace filum::fill
