// How long a machine takes: trapezoidal speed profiles with look-ahead, slowed in corners.
#pragma once

#include "geom/vec.hpp"
#include "machine/profile.hpp"

#include <vector>

namespace filum::machine {

// Adds up the time of moves as they come.  A move speeds up and slows down at its acceleration, never exceeds its feed,
// and enters a corner no faster than the circle through it allows whose deviation from the corner gives `corner_speed`
// at 90 degrees (the rule of Klipper's "square corner velocity"); slower, too, where the arms are shorter than that
// circle.  Look-ahead is at least kAhead moves; one that cannot stop within them is taken to slow down at their end.
class Clock {
  public:
    static constexpr std::size_t kAhead = 2048;
    explicit Clock(const Motion& motion);

    // A straight move by `step` mm at up to `feed` mm/s; no length, no time.
    void move(geom::Vec3 step, double feed, bool extruding);
    // The machine stands for `seconds`.
    void pause(double seconds);
    // All so far, s; the machine then stands.
    double total();

  private:
    struct Leg {
        double length, feed2, acceleration; // mm, (mm/s)2, mm/s2
        double corner2, entry2;             // (mm/s)2: allowed at its start, and planned there
        geom::Vec3 direction;
    };
    void settle(std::size_t count); // times the first `count` legs and drops them
    Motion motion_;
    std::vector<Leg> legs_;
    double speed2_ = 0; // at the start of legs_[0]
    double seconds_ = 0;
};

} // namespace filum::machine
