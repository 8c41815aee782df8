// Breaks of a stroke to turn the axes back: the poses that lift the tool off the part, turn the axes, and come back.
#pragma once

#include "kinematics/track.hpp"
#include "postproc/walk.hpp"

namespace filum::postproc {

struct Leg { // the move to one pose
    Act act = Act::travel;
    Role role = Role::travel;
    std::uint32_t layer = 0;
    double feed = 0, volume = 0, width = 0, height = 0;
    std::uint32_t tool = 0;
    double fed = 0;            // mm of fibre
    bool halt = false;         // the tool stops at its end
    Act before = Act::extrude; // the act before it; Act::extrude: none
    bool straight = true;      // the tip moves straight; false: the axes do
    bool surface = false;      // of a span that leans the tool
    Feature feature = Feature::none;
};

// The motion of a stroke, pose by pose.
struct Motion {
    std::vector<kinematics::Pose> poses;
    std::vector<Leg> legs; // legs[i] leads to poses[i]
    std::vector<kinematics::Joints> joints;
};

// The number of poses that a lift adds.
struct Lifts {
    static constexpr std::size_t kFromAir = 3, kFromPart = 5;
};

// The kind of place where the tool would leave the part, for each pose that `legs` lead to: in the air, in a turn, at a
// join, or on a bead.  `flying`: the first pose is in the air.
std::vector<kinematics::Lifting> liftings(std::span<const Leg> legs, bool flying);

// Returns `motion` with the joints that `track` found for it, and with lifts between the pieces of the track.  In a
// lift the tool rises along its axis by `rise` mm, then straight up to z = `clear` mm, if that is higher.  There the
// axes turn over, and the tool comes back the same way.  From a place in the air (`places`, see liftings) it only rises
// to `clear`.
Motion lifted(const machine::Profile& profile, Motion motion, const kinematics::Track& track,
              std::span<const kinematics::Lifting> places, double rise, double clear);

} // namespace filum::postproc
