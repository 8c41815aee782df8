// Corners of rings rounded on a surface.  Private to lib/surfpath.
#pragma once

#include "curve/line.hpp"
#include "geodesic/exact.hpp"

namespace filum::surfpath {

using curve::Line;
using curve::Place;
using geodesic::ExactField;
using geom::Vec3;
using surface::Isoline;
using surface::Surface;

// Least radii of length that a radian of turning too tight is worth.
inline constexpr double kGain = 3.3;

// One radius to round by: `inner` are the lines as much farther away.
struct Scale {
    double radius;
    std::vector<const Isoline*> inner{};
};

// Isolines of one level that are rounded alike.
struct Batch {
    double level;
    std::vector<const Isoline*> outer;
    std::vector<Scale> scales; // by falling radii
    std::vector<Line> lines{};
};

// Rounds the corners of rings: where a disc, rolling along inside of one, does not come, but for narrow places that lead
// on to others where it does.  A smaller disc takes over where that gains much length for few tight turns.  Where two
// rings, or one, face each other across a neck that is narrower than both by less than a spacing, they run through it.
class Rounding {
  public:
    Rounding(const Surface& surface, const ExactField& field, double least_radius, double spacing);

    void operator()(Batch& batch) const; // finds its lines

  private:
    const Surface& surface_;
    const ExactField& field_;
    double least_, spacing_, edge_;
};

} // namespace filum::surfpath
