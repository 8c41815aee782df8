// How long a machine takes for a toolpath.
#pragma once

#include "machine/motion.hpp"
#include "machine/profile.hpp"
#include "toolpath/path.hpp"

namespace filum::metrics {

// Time of the moves from the first extruding one to the last, by trapezoidal speed profiles with look-ahead
// (machine/motion.hpp). A travel of at least travel.min_length takes back material, rises above all printed so far,
// moves, comes down and primes; one that is shorter only moves, as does a jump between spans.
class Pace {
  public:
    explicit Pace(const machine::Profile& profile) : profile_(profile), clock_(profile.motion) {}
    void add(const toolpath::Span& span);
    double seconds(); // so far

  private:
    void travel(const toolpath::Span& span);
    void extrude(const toolpath::Span& span);
    void go(geom::Vec3 to, double feed);

    machine::Profile profile_;
    machine::Clock clock_;
    geom::Vec3 at_;  // of the nozzle
    double top_ = 0; // highest point printed so far
    bool begun_ = false, retracted_ = false;
};

} // namespace filum::metrics
