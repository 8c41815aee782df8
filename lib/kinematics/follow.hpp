// The way of an arm's axes along a whole stroke.
#pragma once

#include "kinematics/arm.hpp"

#include <limits>
#include <span>

namespace filum::kinematics {

// A place that the tool comes to: straight from the one before, turning evenly the short way.
struct Stand {
    geom::Frame tip;    // in the robot's base: z out of the tool, x where it points at a spin of 0
    double seconds = 0; // that the move to it is to take
};

struct Carried {
    Arm arm;
    geom::Frame tool;    // its tip, seen from the flange
    bool round = false;  // the tool may be turned about its own axis: any spin will do
    double singular = 0; // rad: it keeps that far from singularities where it can
};

// Where the axes stand before a stroke.
struct Before {
    Posture posture{};
    double spin = 0;    // rad, of the tool about its z axis
    bool joint = false; // the first stand is gone to as the axes like, so in any way; else the arm stands there
};

enum class Trouble : std::uint8_t {
    none,
    reach, // no way to stand there: `amount` mm short
    limit, // `axis` would be `amount` rad beyond its limit
    jump,  // the way leads through a singularity: `axis` would have to turn by `amount` rad at once, or pass over from
           // one way to stand to the other
};

struct Hindrance {
    Trouble trouble = Trouble::none;
    std::size_t stand = 0; // to which the move leads
    std::size_t axis = 0;
    double amount = 0;
};

struct Followed {
    std::vector<Posture> postures;  // per stand; as far as there is no hindrance
    std::vector<double> spin;       // rad, per stand
    std::vector<double> needed;     // s, per stand: no axis is faster than it can be if the move to it takes that long
    std::vector<std::uint8_t> axis; // that needs it
    Hindrance hindrance;
    Nearness nearest{Singular::wrist, 10}; // to a singularity, anywhere on the way
    std::size_t nearest_at = 0;
    double room = std::numeric_limits<double>::infinity(); // rad: the least that an axis is from its limit
    std::size_t room_axis = 0, room_at = 0;

    // As if the first `n` stands had not been there; what happened at them counts for the one behind.
    void forget(std::size_t n);
};

// Postures for `stands`, continuous on the whole way, in between, too: moves are halved until no axis turns by more
// than 10 degrees from one look to the next.  The spin stays what it was while that keeps limits and speeds and the
// distance from singularities; where it does not and the tool is round, or where the first stand may be stood at in any
// way, a dynamic programme over the stroke looks for a better one, in steps of 15 degrees that change evenly along
// it: of the ways without hindrance the one of least time of the axes, with what exceeds the seconds given, and what is
// near limits and singularities, counting more.  Ties: the way found first.  If all are hindered, as far as one comes.
Followed follow(const Carried& carried, std::span<const Stand> stands, const Before& before);

// The tip's frame turned by `spin` about its z axis.
geom::Frame spun(const geom::Frame& tip, double spin);

// On the way from one frame to another: straight, and turned evenly the short way.
geom::Frame between(const geom::Frame& from, const geom::Frame& to, double share);

} // namespace filum::kinematics
