// A robot's axes along the strokes of a program: headings of the tool, durations of moves, and places out of reach.
#pragma once

#include "kinematics/follow.hpp"
#include "postproc/arm_efforts.hpp"
#include "postproc/lifts.hpp"

#include <array>
#include <deque>

namespace filum::postproc {

class Carrier {
  public:
    explicit Carrier(const machine::Profile& profile);

    // The heading at every pose of a stroke and of the travel before it: the direction of the tool's x axis, a unit
    // vector perpendicular to the tool axis.  The arm comes from the end of the last stroke.
    std::vector<Vec3> headings(const Motion& stroke);

    // Moves the arm along the stroke.  `headings` may be turned about the tool axis.  `seconds`, the duration of each
    // move, may be lengthened so that the axes can follow.  The tool is changed before leg `change`; the number of
    // legs means no change.  Without a model nothing changes.
    // Throws Error(failure) with stroke, layer, place, axis and amount where the robot cannot follow.
    void carry(const Motion& stroke, std::size_t change, std::vector<double>& seconds, std::vector<Vec3>& headings);

    // True if a joint move leads to pose i of the last stroke: at the very first pose, and after a change of the tool.
    [[nodiscard]] bool jointly(std::size_t i) const { return i == jointly_[0] || i == jointly_[1]; }
    // The posture at such a pose, valid as long as this Carrier; nullptr elsewhere, and without a model.
    [[nodiscard]] const kinematics::Posture* posture(std::size_t i) const;
    [[nodiscard]] const ArmEfforts& efforts() const { return efforts_; }

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    [[noreturn]] void refuse(const kinematics::Hindrance& h, const Motion& stroke) const;
    void part(const Motion& stroke, std::size_t begin, std::size_t end, std::vector<double>& seconds,
              std::vector<Vec3>& headings);
    void count(const kinematics::FollowResult& f, const Motion& stroke, std::size_t begin,
               std::span<const double> seconds);

    const machine::Profile* profile_;
    kinematics::ArmSetup carried_;
    kinematics::StartPosture before_;
    std::deque<kinematics::Posture> stood_; // where joint moves led
    std::array<std::size_t, 2> jointly_{kNone, kNone};
    Vec3 heading_{1, 0, 0};
    geom::Frame last_; // the tool's tip, seen from the robot's base
    std::uint32_t tool_ = 0;
    std::uint64_t stroke_ = 0; // counted from 1
    ArmEfforts efforts_;
};

} // namespace filum::postproc
