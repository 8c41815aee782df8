// Closed lines side by side on a surface: which runs next to which, and where.
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
    double way = 0;      // mm from the lane's first point
    double distance = 0; // mm, straight, from where it was asked for
};

class Lanes {
  public:
    // `lines` are threaded and closed, about `spacing` mm apart.
    Lanes(const Surface& surface, std::vector<Line> lines, double spacing);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(lines_.size()); }
    [[nodiscard]] const Line& line(std::uint32_t lane) const { return lines_[lane]; }
    [[nodiscard]] double length(std::uint32_t lane) const { return ways_[lane].back(); }
    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] Place at(std::uint32_t lane, double way) const;
    [[nodiscard]] Vec3 tangent(std::uint32_t lane, double way) const; // unit
    [[nodiscard]] Line part(std::uint32_t lane, double from, double to) const;
    [[nodiscard]] double curvature(std::uint32_t lane, double way) const; // 1/mm, over a spacing

    // The nearest place on a lane for which use(lane, way) holds, at most `reach` mm away, on the same component, where
    // the surface faces as it does at `from`.  Ties: the first lane, the least way.
    using Use = std::function<bool(std::uint32_t, double)>;
    [[nodiscard]] std::optional<LanePlace> nearest(const Place& from, double reach, const Use& use) const;

    // The lane next to `lane` at `way`, on its right (side 1) or left (-1), between 0.5 and `farthest` spacings away
    // along the surface, which leads there.  It may be the same lane, coming back.
    [[nodiscard]] std::optional<LanePlace> across(std::uint32_t lane, double way, double side, double farthest) const;

    // How far ahead of `from` the place `to` lies on the lane, in the sense given; 0 up to its length.
    [[nodiscard]] double ahead(std::uint32_t lane, double from, double to, double sense) const;

  private:
    struct Node {
        std::uint32_t lane;
        double way;
        Vec3 point, normal;
        std::uint32_t component;
    };
    [[nodiscard]] LanePlace refined(const Node& node, const Vec3& p) const;

    const Surface& surface_;
    std::vector<Line> lines_;
    std::vector<std::vector<double>> ways_;
    double spacing_;
    std::vector<Node> nodes_;
    geom::PointGrid<Vec3> grid_; // of nodes
};

} // namespace filum::surfpath::lanes
