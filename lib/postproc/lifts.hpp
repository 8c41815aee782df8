// Where a stroke must leave the part so that the axes can stand another way: the poses of lifting, turning, coming
// back.
#pragma once

#include "kinematics/track.hpp"
#include "postproc/walk.hpp"

namespace filum::postproc {

struct Leg { // to one pose
    Act act = Act::travel;
    Role role = Role::travel;
    std::uint32_t layer = 0;
    double feed = 0, volume = 0, width = 0, height = 0;
    std::uint32_t tool = 0;
    double fed = 0;            // mm of fibre
    bool halt = false;         // the tool stands at its end
    Act before = Act::extrude; // what comes before it; Act::extrude for nothing
    bool straight = true;      // false: the axes go straight, wherever that takes the tip
    bool surface = false;      // of a span that leans the tool
    Feature feature = Feature::none;
};

// What a stroke's axes do, pose by pose.
struct Motion {
    std::vector<kinematics::Pose> poses;
    std::vector<Leg> legs; // legs[i] leads to poses[i]
    std::vector<kinematics::Joints> joints;
};

// How many poses a change adds.
struct Lifts {
    static constexpr std::size_t kFromAir = 3, kFromPart = 5;
};

// What leaving the part costs at each pose that `legs` lead to; `flying`: the first of them is in the air.
std::vector<kinematics::Lifting> liftings(std::span<const Leg> legs, bool flying);

// `motion` without its joints, and `track` over it, to one with them.  Between two pieces the tool rises along its axis
// by `rise` mm, then upright to `clear` mm of z (if that is higher), where the axes change over, and comes back the
// same way; from the air (`places`: liftings) it only rises to `clear`.
Motion lifted(const machine::Profile& profile, Motion motion, const kinematics::Track& track,
              std::span<const kinematics::Lifting> places, double rise, double clear);

} // namespace filum::postproc
