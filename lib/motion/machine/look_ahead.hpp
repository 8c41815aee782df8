// Planners that look ahead: trapezoidal speed profiles, slowed in corners.
#pragma once

#include "machine/motion.hpp"

#include <vector>

namespace filum::machine {

// The planner of Marlin, Klipper and RepRapFirmware, and of LinuxCNC where only X, Y and Z move.  Each move speeds up
// and slows down at its acceleration.  It never exceeds its feed or a bound of an axis.  It enters a corner no
// faster than the controller's rule allows:
//   marlin, klipper  the speed on a circle that passes the corner with the deviation that gives motion.corner_speed at
//                    90 degrees; slower where the moves are too short for that circle; extruder and rotary axes jump
//                    by no more than their own corner speeds
//   reprapfirmware   no axis jumps by more than its corner speed ("jerk")
//   linuxcnc         the speed on a circle that deviates from the corner by the blend tolerance (G64 P)
// The machine can always stop within motion.look_ahead moves.  Klipper also limits the peak speed of each stretch as if
// it braked more gently, so that it spends motion.minimum_cruise_ratio at one speed.  Arcs are planned as the chords
// that the firmware makes of them.
class LookAhead final : public Planner {
  public:
    explicit LookAhead(const Profile& profile);
    void move(const PlannedMove& move) override;
    double total() override;

  private:
    struct Leg {
        double length = 0, acceleration = 0;       // mm (rad), mm/s2
        double share = 1;                          // acceleration / the one that the corner speed refers to
        double cruise2 = 0, corner2 = 0;           // (mm/s)2: from its feed; allowed at its start
        double gain2 = 0, gentle2 = 0;             // (mm/s)2: gain along its length; with Klipper's gentle acceleration
        double entry2 = 0, most2 = 0, smooth2 = 0; // (mm/s)2 at its start: planned; reachable; reachable gently
        geom::Vec3 direction;
        double extruded = 0, tilt = 0, turn = 0; // per mm
        bool linear = true;                      // X, Y or Z moves
    };
    void straight(const PlannedMove& move);
    [[nodiscard]] double corner2(const Leg& before, const Leg& leg) const;
    [[nodiscard]] double jump2(const Leg& before, const Leg& leg) const;
    void settle(std::size_t count); // times the first `count` legs and drops them
    void plan_entries();
    void plan_window();
    void time_trapezoids(std::size_t count);
    void time_smoothed(std::size_t count);

    Motion motion_;
    MultiAxis axes_;
    double deviation_ = 0;  // (mm/s)2: acceleration times the deviation at a corner
    std::size_t ahead_ = 0; // moves
    std::vector<Leg> legs_;
    double speed2_ = 0;  // (mm/s)2, at the start of legs_[0]
    double smooth2_ = 0; // the same with the gentle acceleration
    double seconds_ = 0;
};

} // namespace filum::machine
