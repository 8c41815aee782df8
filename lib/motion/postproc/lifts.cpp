#include "postproc/lifts.hpp"

#include <algorithm>

namespace filum::postproc {

namespace {

using kinematics::Joints;
using kinematics::Lifting;
using kinematics::Pose;

class Lifter {
  public:
    Lifter(const machine::Profile& profile, Motion& out, double rise, double clear)
        : profile_(profile), chain_(profile.axes.chain), out_(out), rise_(rise), clear_(clear) {}

    // Adds the poses that bring the axes from their positions at the last pose to `to`, which reaches the same pose.
    void change(const Joints& to, bool in_air, std::uint32_t layer, std::uint32_t tool) {
        const Pose at = out_.poses.back();
        const Joints from = out_.joints.back();
        const Leg leg{Act::travel, Role::travel, layer, profile_.feeds.travel, 0, 0, 0, tool};
        const Vec3 up = at.tip + (in_air ? 0 : rise_) * at.axis, high{up.x, up.y, std::max(up.z, clear_)};
        if (!in_air) add(up, from, leg);
        const auto& l = profile_.axes.limits;
        const double upright = std::clamp(0.0, l.tilt_min, l.tilt_max);
        Leg over = leg;
        over.straight = false; // above the part; on a polar machine the tip goes round
        add(high, {{}, upright, from.turn}, leg);
        add(high, {{}, upright, to.turn}, over);
        add(up, to, leg);
        if (!in_air) add(at.tip, to, leg);
    }

  private:
    void add(const Vec3& tip, const Joints& j, const Leg& leg) {
        out_.joints.push_back(kinematics::place(chain_, tip, j.tilt, j.turn));
        out_.poses.push_back({tip, kinematics::forward(chain_, out_.joints.back()).axis});
        out_.legs.push_back(leg);
    }

    const machine::Profile& profile_;
    const kinematics::Chain& chain_;
    Motion& out_;
    double rise_, clear_;
};

} // namespace

std::vector<Lifting> liftings(std::span<const Leg> legs, bool flying) {
    std::vector<Lifting> out(legs.size(), Lifting::bead);
    const auto is = [&](std::size_t i, auto what) {
        return what(legs[i]) || (i + 1 < legs.size() && what(legs[i + 1]));
    };
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const bool travels = legs[i].act == Act::travel && (i + 1 == legs.size() || legs[i + 1].act == Act::travel);
        if (travels && (i > 0 || flying))
            out[i] = Lifting::air;
        else if (is(i, [](const Leg& l) { return l.role == Role::hairpin; }))
            out[i] = Lifting::turn;
        else if (is(i, [](const Leg& l) { return toolpath::extrudes(l.role) && !toolpath::fills(l.role); }))
            out[i] = Lifting::join;
    }
    return out;
}

Motion lifted(const machine::Profile& profile, Motion motion, const kinematics::Track& track,
              std::span<const Lifting> places, double rise, double clear) {
    if (track.pieces.size() == 1) {
        motion.joints = track.pieces[0].joints;
        return motion;
    }
    Motion out;
    Lifter lifter(profile, out, rise, clear);
    for (const auto& piece : track.pieces) {
        const bool first = out.poses.empty();
        if (!first)
            lifter.change(piece.joints[0], places[piece.first] == Lifting::air, motion.legs[piece.first].layer,
                          motion.legs.back().tool);
        for (std::size_t k = first ? 0 : 1; k < piece.joints.size(); ++k) {
            out.poses.push_back(motion.poses[piece.first + k]);
            out.legs.push_back(motion.legs[piece.first + k]);
            out.joints.push_back(piece.joints[k]);
        }
    }
    return out;
}

} // namespace filum::postproc
