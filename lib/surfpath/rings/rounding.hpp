// Corners of rings rounded on a surface.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/curve/line.hpp"
#include "surfpath/rings/ring.hpp"

#include <functional>

namespace filum::surfpath::rings {

using geodesic::ExactField;
using surface::Isoline;

// Lines of equal distance, to measure from.
surface::Sources as_sources(const std::vector<const Isoline*>& lines);

// Isolines of one level that are rounded alike.
struct Batch {
    double level;
    std::uint32_t ring; // how many rings lie outside of it
    std::vector<const Isoline*> outer;
    std::vector<double> radii; // to round by, falling
    std::vector<Ring> rings{}; // those, and how their corners may be rounded
    std::vector<Line> lines{}; // what comes of it
};

// The closed isolines that lie `radius` mm of distance within those of a batch.
using Within = std::function<std::vector<const Isoline*>(double radius)>;

// Rounds the corners of rings: where a disc, rolling along inside of one, does not come, but for narrow places that
// lead on to others where it does.  A smaller disc takes over where that gains much length for few tight turns.  Where
// two rings, or one, face each other across a neck that is narrower than both by less than a spacing, they run through
// it.
class Rounding {
  public:
    Rounding(const Surface& surface, const ExactField& field, double least_radius, double spacing);

    void prepare(Batch& batch, const Within& within) const; // finds its rings

    // What its lines turn, if smaller discs, but none below `floor` mm, take over where they gain `gain` least radii of
    // length for each radian that they turn too tight.
    struct Turns {
        double tight = 0; // rad in all, by which they turn tighter than by the least radius
        double least = 0; // mm, of radii; the least radius if all keep to it
    };
    [[nodiscard]] Turns turns(const Batch& batch, double gain, double floor) const;

    void finish(Batch& batch, double gain, double floor) const; // finds its lines

  private:
    const Surface& surface_;
    const ExactField& field_;
    double least_, spacing_, edge_;
};

} // namespace filum::surfpath::rings
