// What a profile says of the rotary axes of a machine.
#pragma once

#include "kinematics/track.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace filum::machine {

class Document;

// What the numbers of a program are.
enum class Numbers : std::uint8_t {
    tip,    // the tip in the part's frame; the controller moves the axes (tool centre point control, RTCP)
    joints, // where the axes stand, worked out here
};

// What the F word of a move says.
enum class FeedWord : std::uint8_t {
    per_minute, // speed, mm/min, of what X, Y and Z do; of rotary axes alone: degrees/min
    inverse,    // 1 / duration, 1/min (G93)
    seconds,    // duration, s
};

// How a robot's tool stands about its own axis: where its x axis points.
enum class Spin : std::uint8_t {
    fixed,  // as near to the part's x axis as the tool axis allows
    follow, // along the path: for nozzles that are not round
    free,   // for round nozzles: as at the start, and turned where that keeps axes off limits and singularities
};

struct MultiAxis {
    kinematics::Chain chain;   // Carrier::none: three axes, and nothing of the rest counts
    kinematics::Limits limits; // rad
    // Where the axes are taken to stand behind the start template: from there the first stroke is approached.
    std::optional<kinematics::Joints> start;
    char tilt_letter = 'B', turn_letter = 'C';
    double tilt_speed = 1, turn_speed = 2;                         // rad/s
    double tilt_acceleration = 10, turn_acceleration = 20;         // rad/s2
    double tilt_corner_speed = 0.0873, turn_corner_speed = 0.1745; // rad/s that the axis may jump from move to move
    Numbers numbers = Numbers::joints;
    FeedWord feed_word = FeedWord::inverse;
    std::string tcp_on, tcp_off; // codes around what has tip numbers
    double chord = 0.005;        // mm: how far the tip may leave its line between two lines of joints
    double orientation = 0.0349; // rad: how far the tool may lean off its axis near the pole
    double blend = 0.5;          // mm: how far before a place a robot may leave its line
    Spin spin = Spin::fixed;
    int angle_decimals = 4; // of rotary words, degrees

    [[nodiscard]] bool active() const { return chain.carrier != kinematics::Carrier::none; }
};

// Reads the section [kinematics]; without one nothing changes.  Throws Error(bad_input) as parse_profile does.
void read_multi_axis(Document& doc, MultiAxis& out);

} // namespace filum::machine
