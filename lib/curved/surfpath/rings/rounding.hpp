// Rounds the corners of rings on a surface.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/curve/line.hpp"
#include "surfpath/rings/ring.hpp"

#include <functional>

namespace filum::surfpath::rings {

using geodesic::ExactField;
using surface::Isoline;

// The isolines as source segments, to measure distances from them.
surface::Sources as_sources(const std::vector<const Isoline*>& lines);

// Isolines of one level that are rounded with the same radii.
struct Batch {
    double level;
    std::uint32_t ring; // number of rings outside of it
    std::vector<const Isoline*> outer;
    std::vector<double> radii; // radii of rounding, decreasing
    std::vector<Ring> rings{}; // the isolines with their corners
    std::vector<Line> lines{}; // the result
};

// The closed isolines inside those of a batch, at a level `radius` mm higher.
using Within = std::function<std::vector<const Isoline*>(double radius)>;

// Rounds corners of rings by rolling a disc along the inside: stretches that the disc does not touch are replaced by
// its arc, unless a narrow place leads from them to others that it touches. A smaller disc is used where it gains much
// length for few tight turns. Where rings face each other across a neck that is less than a spacing narrower than
// both, they are connected through it.
class Rounding {
  public:
    Rounding(const Surface& surface, const ExactField& field, double least_radius, double spacing);

    void prepare(Batch& batch, const Within& within) const; // computes its rings

    // The angle by which turns of the batch's lines exceed that of the least radius, rad, if smaller discs are used
    // where they gain `gain` least radii of length per radian of it.
    [[nodiscard]] double tight(const Batch& batch, double gain) const;

    void finish(Batch& batch, double gain) const; // computes its lines

  private:
    const Surface& surface_;
    const ExactField& field_;
    double least_, spacing_, edge_;
};

} // namespace filum::surfpath::rings
