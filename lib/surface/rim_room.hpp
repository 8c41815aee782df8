// How much room there is beyond the rims of a surface, until another part of a rim comes near.
#pragma once

#include "geom/bvh.hpp"
#include "surface/surface.hpp"

#include <vector>

namespace filum::surface {

// A vertex of a rim, and a unit direction out from it, in the tangent plane.
struct Station {
    std::uint32_t vertex = 0;
    std::size_t edge = 0; // of the outline: that begins there
    Vec3 out;
};

// A rim as a polygon through some of its vertices, no others farther from it than a tolerance: what is finer than that
// is the noise of a mesh, whose sides point anywhere.
struct Outline {
    struct Edge {
        std::size_t side = 0; // of the rim: the first
        Vec3 up, out;         // of the surface beside it; square to that and to the edge, away from the surface; unit
    };
    std::vector<Edge> edges;       // each to where the next begins
    std::vector<Station> stations; // where edges begin: several about a corner that sticks out, else one
};

// How deep a flange may be out from places of the rims.
class RimRoom {
  public:
    // `depth` mm at most; rims count as known to within `tolerance` mm.
    RimRoom(const Surface& s, double depth, double tolerance);

    [[nodiscard]] const Outline& outline(std::size_t rim) const { return outlines_[rim]; }

    // Half the radius of the greatest ball that touches the rim at the station and has no point of an outline inside;
    // at most the depth, 0 where rims touch. Of the two edges that meet there only the ends count: they stand for a
    // smooth line. A point beside which the outline faces the same way may lie in the ball by the tolerance.
    [[nodiscard]] double at(const Station& from) const;

  private:
    struct Edge { // of an outline
        Vec3 a, b, out;
        std::uint32_t from = 0, to = 0; // vertices
    };
    struct Point {
        Vec3 at;
        std::uint32_t edge = 0;
    };
    void add(const Rim& rim, const Outline& outline);
    std::vector<geom::Box3> boxes();
    // Of the ball that touches the point.
    [[nodiscard]] double radius(const Station& from, const Point& other) const;

    const Surface& s_;
    double depth_, tolerance_;
    std::vector<Outline> outlines_; // per rim
    std::vector<Edge> edges_;
    std::vector<Point> points_;
    geom::Bvh tree_;
};

} // namespace filum::surface
