// Rings: the lanes of a region as closed lines, each along the middle of its strip.
#pragma once

#include "rings/beading.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::rings {

inline constexpr std::uint32_t kNoPoint = 0xffffffff;

// Ring i has the points start[i] .. start[i + 1]; closed, solid on the left, none crossing another or itself.
struct Rings {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point: of the strip there
    std::vector<double> depth; // mm, per point: to the outline
    std::vector<std::uint32_t> start{0};
    std::vector<int> lane; // per ring, counted from 1 along the outline; ascending

    // Where rings pass the ray to the first node of half-edge h: lane k at entry ray_start[h] + k - 1 of these, for the
    // lanes that are laid there.
    std::vector<std::uint32_t> ray_start;
    std::vector<std::uint32_t> ray_point; // index of points; kNoPoint where that ring was left out
    // From there it runs along h up to this share of it, all of it or to where it turns back; and its point there.
    std::vector<double> end_share;
    std::vector<std::uint32_t> end_point;

    [[nodiscard]] std::size_t size() const { return lane.size(); }
    [[nodiscard]] int lanes_on(std::uint32_t h) const { return static_cast<int>(ray_start[h + 1] - ray_start[h]); }
    [[nodiscard]] std::uint32_t entry(std::uint32_t h, int lane) const {
        return ray_start[h] + static_cast<std::uint32_t>(lane) - 1;
    }
};

// The rings of lanes 1 to `most` (all: 0), lane by lane.  Arcs are off by at most `tolerance` mm.  Rings inside others
// that would lay no more than the edge of a bead flows over are left out.
Rings rings(const Beading& beading, int most, double tolerance);

// The point of lane coordinate f on the ray to the share t of half-edge h, from its first node, in h's part of the
// outline; and its depth, mm.
struct RayPoint {
    Vec2 point;
    double depth;
};
RayPoint on_ray(const Beading& beading, std::uint32_t h, double t, double f);

} // namespace filum::rings
