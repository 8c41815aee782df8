// From the spans of a toolpath to the steps of a machine with rotary axes.
#pragma once

#include "postproc/carry.hpp"
#include "postproc/lifts.hpp"

#include <set>

namespace filum::postproc {

// Stroke by stroke, with the travel that leads to it: poses along the spans (their normals; upright without), joints
// that follow them (kinematics::track), and steps whose numbers are the tip's or the joints'.  Between two steps of
// joints the axes move straight; as many are written as keep the tip to its line, and no more than the profile's
// Merging needs (poses.hpp).
//
// A travel of spans with normals goes as they say.  One without rises first above all printed so far, as a Walk's.
// How long a move takes: by the tip's feed and the speed of each axis; longer where a rotary axis would have to change
// its speed faster than it can, so the path slows down, never the reverse; and where the controller takes no more moves
// at a time (throughput.hpp).
// Where an axis would leave its limits the stroke is broken and the axes turned back in the air (see lifts.hpp), which
// the efforts count.  Throws Error(failure) naming the place that the axes cannot reach, or where the tool would lean
// off its axis by more than the profile's orientation.
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
    machine::Profile tip_; // the same without a limit on z: what rises in the part is no axis of the machine
    Vec3 shift_;
    Steps out_;
    std::vector<Step> buffer_;
    Motion stroke_;              // being read; its joints only when it is finished
    std::vector<Vec3> headings_; // of robots, per pose: where the tool's x axis points
    Carrier carrier_;            // likewise: its axes
    kinematics::Joints at_;      // after the last stroke
    double top_ = 0;
    std::int64_t layer_ = -1;
    bool laid_ = false;       // a bead of this stroke
    std::size_t landing_ = 0; // the leg of this stroke that leads to its start
    bool ended_ = false;      // nothing more is laid
    std::uint32_t tool_ = 0;
    std::set<std::uint32_t> retracted_; // tools
};

} // namespace filum::postproc
