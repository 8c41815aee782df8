// The time that a machine takes: models of the motion planners of controllers.
#pragma once

#include "geom/vec.hpp"
#include "machine/profile.hpp"

#include <memory>

namespace filum::machine {

// A move as the controller sees it.
struct PlannedMove {
    geom::Vec3 step;           // mm, of the program's X, Y and Z
    double feed = 0;           // mm/s along the step; rad/s where only rotary axes move
    double tilt = 0, turn = 0; // rad
    double extruded = 0;       // extruder units
    bool extruding = false;
    double acceleration = 0; // mm/s2, of an extruding move; 0: motion.acceleration
    double sweep = 0;        // rad of an arc, positive counter-clockwise; 0: straight
    geom::Vec2 arm{};        // mm, of an arc, from its centre to its start
};

class Planner {
  public:
    virtual ~Planner() = default;
    virtual void move(const PlannedMove& move) = 0;
    virtual double total() = 0; // s of all moves so far; the machine then stops
};

// The planner of profile.motion.controller; see look_ahead.hpp and parabolic.hpp.
std::unique_ptr<Planner> planner(const Profile& profile);

// Adds up the time of moves and pauses as they come.
class Clock {
  public:
    explicit Clock(const Profile& profile) : planner_(planner(profile)) {}
    // A move without length and turn takes no time.
    void move(const PlannedMove& move) { planner_->move(move); }
    // The machine stands for `seconds`.
    void pause(double seconds);
    // All time so far, s; the machine then stops.
    double total() { return paused_ + planner_->total(); }

  private:
    std::unique_ptr<Planner> planner_;
    double paused_ = 0;
};

// Time in s for `length` from standstill to standstill, at `speed` at most; `acceleration` may be infinite.
double stop_to_stop(double length, double speed, double acceleration);

// The largest speed or acceleration along a way of `length` if one axis does `part` of it and is limited to `bound`;
// infinite if the axis does not move.
inline double along(double bound, double part, double length) {
    const double own = part < 0 ? -part : part;
    return own > 0 ? bound * length / own : std::numeric_limits<double>::infinity();
}

} // namespace filum::machine
