// Planners that look ahead: trapezoidal speed profiles, slowed in corners.
#pragma once

#include "machine/motion.hpp"

#include <vector>

namespace filum::machine {

// Marlin, Klipper, RepRapFirmware; LinuxCNC where only X, Y and Z move.  Each move speeds up and slows down at its
// acceleration, never exceeds its feed nor the bounds of an axis, and enters a corner no faster than the controller's
// rule allows:
//   marlin, klipper  the circle through the corner whose deviation from it gives motion.corner_speed at 90 degrees;
//                    slower where the arms are shorter than that circle; extruder and rotary axes jump by no more
//                    than their own corner speeds
//   reprapfirmware   no axis jumps by more than its corner speed ("jerk")
//   linuxcnc         the circle that leaves the corner by the blend tolerance (G64 P)
// It can always stop within motion.look_ahead moves.  Klipper also plans the peaks of stretches as if it braked more
// gently, so that motion.minimum_cruise_ratio of each is at one speed.  Arcs are the chords that the firmware makes.
class LookAhead final : public Planner {
  public:
    explicit LookAhead(const Profile& profile);
    void move(const PlannedMove& move) override;
    double total() override;

  private:
    struct Leg {
        double length = 0, acceleration = 0;       // mm (rad), mm/s2
        double share = 1;                          // of the acceleration that the corner speed is meant for
        double cruise2 = 0, corner2 = 0;           // (mm/s)2: of its feed, allowed at its start
        double gain2 = 0, gentle2 = 0;             // (mm/s)2 that it can gain along its length; more gently
        double entry2 = 0, most2 = 0, smooth2 = 0; // planned at its start; reached there at most; more gently
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
    double deviation_ = 0;  // mm2/s2: acceleration times the corner's deviation
    std::size_t ahead_ = 0; // moves
    std::vector<Leg> legs_;
    double speed2_ = 0;  // at the start of legs_[0]
    double smooth2_ = 0; // likewise, more gently
    double seconds_ = 0;
};

} // namespace filum::machine
