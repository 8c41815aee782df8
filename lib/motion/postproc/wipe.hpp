// The wipe of a nozzle: it goes back over the last bead while it takes the material back.
#pragma once

#include "machine/profile.hpp"

#include <deque>
#include <vector>

namespace filum::postproc {

using geom::Vec3;

// Whether retractions of this kind wipe: machines with rotary axes and firmware that retracts do not.
bool wipes(const machine::Profile& profile, const machine::Travel& travel);

// The feed of a wipe that is `length` mm long, mm/s: not so fast that the material is taken back faster than the
// travel's retract_speed.
double wipe_feed(const machine::Travel& travel, const machine::Feeds& feeds, double length);

// The duration of a retraction with its wipe, s.
double retract_seconds(const machine::Profile& profile, std::uint32_t tool);

// The last places of the nozzle over the beads of a stroke, in one unit of length.
class WipePath {
  public:
    void clear();
    // Adds a straight bead between these places.  Places from which less than `keep` is left to the end are kept.
    void add(const Vec3& from, const Vec3& to, double keep);
    // The places of the way back from the end, at most `most` long.  It ends where the height changes.
    [[nodiscard]] std::vector<Vec3> back(double most) const;

  private:
    double length_ = 0;
    std::deque<Vec3> places_;
};

} // namespace filum::postproc
