// LinuxCNC where rotary axes move: parabolic blends, without look-ahead.
#pragma once

#include "machine/motion.hpp"

namespace filum::machine {

// Each move is planned from standstill to standstill at half of the acceleration that its axes allow; while it slows
// down, the next one speeds up with the other half.  So it never goes faster than it could stop within its own length,
// however smooth the path: v2 <= length * acceleration / 2.  The blend is cut short so that the path leaves the corner
// by no more than the blend tolerance (G64 P).  Speeds and accelerations are bounded axis by axis, those of a rotary
// axis in its own unit.
class Parabolic final : public Planner {
  public:
    explicit Parabolic(const Profile& profile);
    void move(const PlannedMove& move) override;
    double total() override;

  private:
    struct Segment {
        double length = 0, speed = 0, acceleration = 0; // mm or rad; the half that is its own
        geom::Vec3 start, end;                          // unit directions of acceleration
    };
    [[nodiscard]] Segment segment(const PlannedMove& move) const;
    void run(const Segment* next);

    Motion motion_;
    MultiAxis axes_;
    Segment at_; // being run
    bool any_ = false;
    double begun_ = 0, speed_ = 0; // of it, while the one before was slowing down
    double seconds_ = 0;
};

} // namespace filum::machine
