// The planner of LinuxCNC where rotary axes move: parabolic blends without look-ahead.
#pragma once

#include "machine/motion.hpp"

namespace filum::machine {

// Each move is planned from standstill to standstill at half of the acceleration that its axes allow.  While it slows
// down, the next move speeds up with the other half.  So its speed never exceeds what it can lose within its own
// length, even on a smooth path: v2 <= length * acceleration / 2.  The blend is shortened so that the path deviates
// from the corner by at most the blend tolerance (G64 P).  Speeds and accelerations are limited axis by axis; a rotary
// axis has its own unit.
class Parabolic final : public Planner {
  public:
    explicit Parabolic(const Profile& profile);
    void move(const PlannedMove& move) override;
    double total() override;

  private:
    struct Segment {
        double length = 0, speed = 0, acceleration = 0; // mm or rad; half of the axes' acceleration
        geom::Vec3 start, end;                          // unit directions of motion
    };
    [[nodiscard]] Segment segment(const PlannedMove& move) const;
    void run(const Segment* next);

    Motion motion_;
    MultiAxis axes_;
    Segment at_; // the current move
    bool any_ = false;
    double begun_ = 0, speed_ = 0; // of the current move at the end of the last one: way done, and speed
    double seconds_ = 0;
};

} // namespace filum::machine
