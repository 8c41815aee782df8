// How much room there is beyond the rims of a surface, until another part of a rim comes near.
#pragma once

#include "geom/bvh.hpp"
#include "surface/surface.hpp"

namespace filum::surface {

// A vertex of a rim, and a unit direction out from it, in the tangent plane.
struct Station {
    std::uint32_t vertex = 0;
    Vec3 out;
};

// Square to the side `h` of a rim, along the surface and away from it; unit.
Vec3 outwards(const Surface& s, std::uint32_t h);

// Those of the rim, along it: several about a corner that sticks out, else one.
std::vector<Station> stations(const Surface& s, const Rim& rim);

// How deep a flange may be out from places of the rims.
class RimRoom {
  public:
    RimRoom(const Surface& s, double depth); // mm, at most

    // Half the radius of the greatest ball that touches the rim at the station and has no point of it inside; at most
    // the depth.  Of the two sides that meet there only the ends count: they stand for a smooth line.
    [[nodiscard]] double at(const Station& from) const;

  private:
    struct Point {
        Vec3 at;
        std::uint32_t from = kNone, to = kNone; // the vertices that it lies between, or the one that it is, twice
    };
    [[nodiscard]] static std::vector<Point> points(const Surface& s, double apart);
    [[nodiscard]] std::vector<geom::Box3> boxes() const;

    const Surface& s_;
    double depth_;
    std::vector<Point> points_;
    geom::Bvh tree_;
};

} // namespace filum::surface
