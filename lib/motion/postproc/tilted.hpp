// From the spans of a toolpath to the steps of a machine with rotary axes.
#pragma once

#include "postproc/carry.hpp"
#include "postproc/lifts.hpp"

#include <set>

namespace filum::postproc {

// Each stroke is planned as a whole, together with the travel that leads to it:
// 1. Poses follow the spans: the tool along their normals, upright where they have none.
// 2. Joints follow the poses (kinematics::track).  Where an axis would leave its limits, the stroke is broken and the
//    axes turn back in the air (lifts.hpp); the efforts count such breaks.
// 3. Poses are added to keep the tip on its line, and removed where the profile's Merging allows it (poses.hpp).
// 4. Each move becomes a step whose numbers are the tip's or the joints'.
//
// A travel with normals follows its points.  One without normals rises above all printed so far first, as in Walk.
// The duration of a move follows from the tip's feed and the speed of each axis.  It is longer where a rotary axis
// cannot change its speed so fast, and where the controller takes no more moves per second (throughput.hpp).
// Throws Error(failure) with a place that the axes cannot reach, or where the tool would lean off its axis by more than
// the profile's orientation.
class TiltedWalk final : public Walker {
  public:
    TiltedWalk(const machine::Profile& profile, Vec2 shift, Steps out);
    void end() override;

  private:
    void approach(const toolpath::Span& first);
    void retreat();
    void travel(const toolpath::Span& span) override;
    void extrude(const toolpath::Span& span) override;
    void go(const kinematics::Pose& pose, const Leg& leg);
    void finish_stroke();
    void check(const kinematics::Track& track) const;
    void note(const kinematics::Track& track, std::span<const kinematics::Lifting> places);
    void emit(const std::vector<double>& seconds);
    void move(std::size_t to, double seconds);
    [[nodiscard]] std::vector<double> durations();
    [[nodiscard]] std::size_t exchange() const;
    void put(const Step& step);
    [[nodiscard]] double swing(std::size_t i) const;
    [[nodiscard]] std::vector<double> cuts(const kinematics::Pose& pose) const;
    [[nodiscard]] double over_axis(const kinematics::Pose& pose) const;

    [[nodiscard]] const machine::Profile& own() const { return machine::of_tool(*profile_, tool_); } // for the tool

    const machine::Profile* profile_;
    machine::Profile tip_; // the same without a limit on z: the part's z is no axis of the machine
    Vec3 shift_;
    Steps out_;
    std::vector<Step> buffer_;
    Motion stroke_;              // being read; it has joints only in finish_stroke()
    std::vector<Vec3> headings_; // of robots, by pose: direction of the tool's x axis
    Carrier carrier_;            // of robots: the arm
    kinematics::Joints at_;      // at the end of the last stroke
    double top_ = 0;
    std::int64_t layer_ = -1;
    bool laid_ = false;       // this stroke has a bead
    std::size_t landing_ = 0; // the leg of this stroke that leads to its start
    bool ended_ = false;      // the last stroke is finished
    std::uint32_t tool_ = 0;
    std::set<std::uint32_t> retracted_; // tools
};

} // namespace filum::postproc
