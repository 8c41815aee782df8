// The path of an arm's axes along a whole stroke.
#pragma once

#include "kinematics/arm.hpp"

#include <limits>
#include <span>

namespace filum::kinematics {

// A frame that the tool passes: straight from the one before, rotating evenly by the shorter way.
struct TimedFrame {
    geom::Frame tip;    // in the robot's base: z out of the tool, x its direction at spin 0
    double seconds = 0; // intended time of the move to it
};

struct ArmSetup {
    Arm arm;
    geom::Frame tool;    // the tip, seen from the flange
    bool round = false;  // the tool may be rotated about its own axis: any spin is allowed
    double singular = 0; // rad: preferred least distance from singularities
};

// The state of the axes before a stroke.
struct StartPosture {
    Posture posture{};
    double spin = 0; // rad, of the tool about its z axis
    // the move to the first stand is free, so any posture is allowed there; otherwise the arm is already there
    bool joint = false;
};

enum class FollowFailure : std::uint8_t {
    none,
    reach, // out of reach: `amount` mm short
    limit, // `axis` would be `amount` rad beyond its limit
    jump,  // the way leads through a singularity: `axis` would jump by `amount` rad, or the configuration would change
};

struct Hindrance {
    FollowFailure trouble = FollowFailure::none;
    std::size_t stand = 0; // the end of the move
    std::size_t axis = 0;
    double amount = 0;
};

// The result of follow(), as far as there is no hindrance.
struct FollowResult {
    std::vector<Posture> postures;  // per stand
    std::vector<double> spin;       // rad, per stand
    std::vector<double> needed;     // s, per stand: least time of the move to it at which no axis exceeds its speed
    std::vector<std::uint8_t> axis; // the axis that needs it
    Hindrance hindrance;
    Nearness nearest{Singular::wrist, 10}; // to a singularity, anywhere on the way
    std::size_t nearest_at = 0;
    double room = std::numeric_limits<double>::infinity(); // rad: least distance of an axis from its limit
    std::size_t room_axis = 0, room_at = 0;

    // Removes the first `n` stands; what happened at them is attributed to the next one.
    void forget(std::size_t n);
};

// Postures for `stands`, continuous along the whole way: moves are halved until no axis turns by more than 10 degrees
// per step. The spin stays constant while that keeps limits, speeds and the distance from singularities. If it does
// not and the tool is round, or if the first stand may be reached in any posture, dynamic programming over the stroke
// searches a better spin in steps of 15 degrees that change evenly: of the ways without hindrance the one of least
// time of the axes, with penalties for exceeding the given times and for limits and singularities nearby. Ties: the
// way found first. If all are hindered, the one that gets farthest.
FollowResult follow(const ArmSetup& carried, std::span<const TimedFrame> stands, const StartPosture& before);

// The tip's frame rotated by `spin` about its z axis.
geom::Frame spun(const geom::Frame& tip, double spin);

// The frame at `share` of the way between two frames: straight, and rotating evenly by the shorter way.
geom::Frame between(const geom::Frame& from, const geom::Frame& to, double share);

} // namespace filum::kinematics
