// Closed lines side by side on a surface, with a search for the neighbour at each place.
#pragma once

#include "geom/point_grid.hpp"
#include "surface/curve/walk.hpp"

#include <functional>
#include <optional>

namespace filum::surfpath::lanes {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// A place on a lane.
struct LanePlace {
    std::uint32_t lane = 0;
    double arc = 0;      // mm from the lane's first point
    double distance = 0; // mm, straight, from the place for which it was searched
};

class Lanes {
  public:
    // `lines` are threaded, closed and about `spacing` mm apart.
    Lanes(const Surface& surface, std::vector<Line> lines, double spacing);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(lines_.size()); }
    [[nodiscard]] const Line& line(std::uint32_t lane) const { return lines_[lane]; }
    [[nodiscard]] double length(std::uint32_t lane) const { return arcs_[lane].back(); }
    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] Place at(std::uint32_t lane, double arc) const;
    [[nodiscard]] Vec3 tangent(std::uint32_t lane, double arc) const; // unit
    [[nodiscard]] Line part(std::uint32_t lane, double from, double to) const;
    [[nodiscard]] double curvature(std::uint32_t lane, double arc) const; // 1/mm, over a spacing

    // The nearest place for which use(lane, arc) holds, at most `reach` mm from `from`, on the same component, where
    // the surface faces the same way. Ties: the first lane, the least arc length.
    using Use = std::function<bool(std::uint32_t, double)>;
    [[nodiscard]] std::optional<LanePlace> nearest(const Place& from, double reach, const Use& use) const;

    // The neighbour of `lane` at `way` on its right (side 1) or left (side -1), at most
    // `farthest` spacings away along the surface. It may be another part of the same lane.
    [[nodiscard]] std::optional<LanePlace> across(std::uint32_t lane, double arc, double side, double farthest) const;

    // Arc length from `from` to `to` along the lane (sense 1) or against it (-1): from 0 to less than its length.
    [[nodiscard]] double ahead(std::uint32_t lane, double from, double to, double sense) const;

  private:
    struct Node {
        std::uint32_t lane;
        double arc;
        Vec3 point, normal;
        std::uint32_t component;
    };
    [[nodiscard]] LanePlace refined(const Node& node, const Vec3& p) const;

    const Surface& surface_;
    std::vector<Line> lines_;
    std::vector<std::vector<double>> arcs_;
    double spacing_;
    std::vector<Node> nodes_;
    geom::PointGrid<Vec3> grid_; // of nodes
};

} // namespace filum::surfpath::lanes
