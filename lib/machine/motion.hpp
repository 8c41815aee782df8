// How long a machine takes: what its controller's planner makes of moves, one after the other.
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
    double acceleration = 0; // mm/s2, of what extrudes; 0: motion.acceleration
    double sweep = 0;        // rad of an arc, positive counter-clockwise; 0: straight
    geom::Vec2 arm{};        // mm, of an arc, from its centre to where it begins
};

class Planner {
  public:
    virtual ~Planner() = default;
    virtual void move(const PlannedMove& move) = 0;
    virtual double total() = 0; // s of all so far; the machine then stands
};

// What profile.motion.controller names; see look_ahead.hpp, parabolic.hpp.
std::unique_ptr<Planner> planner(const Profile& profile);

// Adds up the time of moves and pauses as they come.
class Clock {
  public:
    explicit Clock(const Profile& profile) : planner_(planner(profile)) {}
    // No length and no turn, no time.
    void move(const PlannedMove& move) { planner_->move(move); }
    // The machine stands for `seconds`.
    void pause(double seconds);
    // All so far, s; the machine then stands.
    double total() { return paused_ + planner_->total(); }

  private:
    std::unique_ptr<Planner> planner_;
    double paused_ = 0;
};

// s for `length` at up to `speed` from standstill to standstill; `acceleration` may be infinite.
double stop_to_stop(double length, double speed, double acceleration);

// What an axis' bounds leave of a speed or acceleration along a way of `length`, of which it does `part`.
inline double along(double bound, double part, double length) {
    const double own = part < 0 ? -part : part;
    return own > 0 ? bound * length / own : std::numeric_limits<double>::infinity();
}

} // namespace filum::machine
