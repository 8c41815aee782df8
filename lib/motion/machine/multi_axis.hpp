// The rotary axes of a machine: [kinematics] of a profile.
#pragma once

#include "kinematics/track.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace filum::machine {

class Document;

// The meaning of a program's coordinates.
enum class Numbers : std::uint8_t {
    tip,    // the tip in the part's frame; the controller moves the axes (tool centre point control, RTCP)
    joints, // the positions of the axes, computed by Filum
};

// The meaning of a move's F word.
enum class FeedWord : std::uint8_t {
    per_minute, // mm/min along X, Y and Z; degrees/min where only rotary axes move
    inverse,    // 1 / duration, 1/min (G93)
    seconds,    // duration, s
};

// The turn of a robot's tool about its own axis, given by the direction of its x axis.
enum class Spin : std::uint8_t {
    fixed,  // as near to the part's x axis as the tool axis allows
    follow, // along the path, for nozzles that are not round
    free,   // as at the start, but turned to avoid limits and singularities; for round nozzles
};

struct MultiAxis {
    kinematics::Chain chain;   // Carrier::none: three axes, and the other members are not used
    kinematics::Limits limits; // rad
    // The assumed positions of the axes after the start template, from where the first stroke is approached.
    std::optional<kinematics::Joints> start;
    char tilt_letter = 'B', turn_letter = 'C';
    double tilt_speed = 1, turn_speed = 2;                         // rad/s
    double tilt_acceleration = 10, turn_acceleration = 20;         // rad/s2
    double tilt_corner_speed = 0.0873, turn_corner_speed = 0.1745; // rad/s that the axis may jump from move to move
    Numbers numbers = Numbers::joints;
    FeedWord feed_word = FeedWord::inverse;
    std::string tcp_on, tcp_off; // codes before and after moves whose numbers are the tip's
    double chord = 0.005;        // mm: largest distance of the tip from its line between two poses of joints
    double orientation = 0.0349; // rad: largest lean of the tool off its axis, near the pole
    double blend = 0.5;          // mm: distance before a place where a robot may leave its line
    Spin spin = Spin::fixed;
    int angle_decimals = 4; // of rotary words, degrees

    [[nodiscard]] bool active() const { return chain.carrier != kinematics::Carrier::none; }
};

// Reads the section [kinematics]; without one nothing changes.  Throws Error(bad_input) as parse_profile does.
void read_multi_axis(Document& doc, MultiAxis& out);

} // namespace filum::machine
