// The room beyond the rims of a surface before another part of a rim.
#pragma once

#include "geom/bvh.hpp"
#include "surface/surface.hpp"

#include <vector>

namespace filum::surface {

// A vertex of a rim and a unit direction outwards in the tangent plane.
struct Station {
    std::uint32_t vertex = 0;
    std::size_t edge = 0; // the edge of the outline that begins there
    Vec3 out;
};

// A rim simplified to a polygon through some of its vertices; the others are within a tolerance of it. Finer details
// are noise of the mesh, whose sides have arbitrary directions.
struct Outline {
    struct Edge {
        std::size_t side = 0; // its first side of the rim
        // normal of the surface beside it; direction outwards, perpendicular to that and to the edge; unit
        Vec3 up, out;
    };
    std::vector<Edge> edges;       // each up to where the next begins
    std::vector<Station> stations; // where edges begin: several at a convex corner, otherwise one
};

// The possible depth of a flange at places of the rims.
class RimRoom {
  public:
    // `depth` mm at most; rims are accurate to `tolerance` mm.
    RimRoom(const Surface& s, double depth, double tolerance);

    [[nodiscard]] const Outline& outline(std::size_t rim) const { return outlines_[rim]; }

    // Half the radius of the largest ball that touches the rim at the station and contains no point of an outline; at
    // most the depth, 0 where rims touch. Of the two edges at the station only the ends count, since they approximate
    // a smooth line. Points at which the outline faces the same way may be inside the ball by the tolerance.
    [[nodiscard]] double at(const Station& from) const;

  private:
    struct Edge { // an edge of an outline
        Vec3 a, b, out;
        std::uint32_t from = 0, to = 0; // its vertices
    };
    struct Point {
        Vec3 at;
        std::uint32_t edge = 0;
    };
    void add(const Rim& rim, const Outline& outline);
    std::vector<geom::Box3> boxes();
    // Radius of the ball at the station that also touches the point.
    [[nodiscard]] double radius(const Station& from, const Point& other) const;

    const Surface& s_;
    double depth_, tolerance_;
    std::vector<Outline> outlines_; // per rim
    std::vector<Edge> edges_;
    std::vector<Point> points_;
    geom::Bvh tree_;
};

} // namespace filum::surface
