// A robot's axes along the strokes of a program: headings of the tool, how long moves take, and what cannot be done.
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

    // Headings for the poses of a stroke with the travel that leads to it, before which the arm stands where the last
    // one ended: where the tool points its x axis, unit and across the tool axis.
    std::vector<Vec3> headings(const Motion& stroke);

    // Takes the stroke with those headings, which it may turn about the tool axis, and with the seconds that its moves
    // are to take, which it may lengthen so that the axes can follow; the tool is changed before leg `change` (none:
    // as many as legs).  Without a model nothing changes.
    // Throws Error(failure) with stroke, layer, place, axis and amount where the robot cannot follow.
    void carry(const Motion& stroke, std::size_t change, std::vector<double>& seconds, std::vector<Vec3>& headings);

    // Whether the axes go as they like to pose i of the stroke taken last: at first, and behind a change of the tool.
    [[nodiscard]] bool jointly(std::size_t i) const { return i == jointly_[0] || i == jointly_[1]; }
    // How they stand there, for as long as this lives; none without a model.
    [[nodiscard]] const kinematics::Posture* posture(std::size_t i) const;
    [[nodiscard]] const ArmEfforts& efforts() const { return efforts_; }

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    [[noreturn]] void refuse(const kinematics::Hindrance& h, const Motion& stroke) const;
    void part(const Motion& stroke, std::size_t begin, std::size_t end, std::vector<double>& seconds,
              std::vector<Vec3>& headings);
    void count(const kinematics::Followed& f, const Motion& stroke, std::size_t begin, std::span<const double> seconds);

    const machine::Profile* profile_;
    kinematics::Carried carried_;
    kinematics::Before before_;
    std::deque<kinematics::Posture> stood_; // where it went as the axes like
    std::array<std::size_t, 2> jointly_{kNone, kNone};
    Vec3 heading_{1, 0, 0};
    geom::Frame last_; // of the tool's tip, in the robot's base
    std::uint32_t tool_ = 0;
    std::uint64_t stroke_ = 0; // counted from 1
    ArmEfforts efforts_;
};

} // namespace filum::postproc
