// One move of an arm, straight from one place to the next.
#pragma once

#include "kinematics/follow.hpp"

namespace filum::kinematics {

// What happens on the way from one place to the next.
struct Passing {
    Posture to{};
    double needed = 0; // s
    std::size_t axis = 0;
    Nearness nearest{Singular::wrist, 10};
    double room = std::numeric_limits<double>::infinity(); // rad, of an axis from its limit; negative: beyond
    std::size_t room_axis = 0;
    Hindrance hindrance;
};

class Follower {
  public:
    explicit Follower(const Carried& carried) : c_(carried), back_(geom::inverse(carried.tool)) {} // it is referred to

    // Takes a posture's place among what was passed.
    void look(const Posture& q, Passing& p) const;

    // Straight on from `a`, where the arm stands at `from`; `to` is as far as it comes.
    [[nodiscard]] Passing pass(const geom::Frame& a, const Posture& from, const geom::Frame& b) const;

    [[nodiscard]] std::vector<Posture> ways(const geom::Frame& tip, const Posture& near, Lack* lack) const;

  private:
    [[nodiscard]] std::optional<Posture> on(const geom::Frame& tip, const Posture& near, Passing& p) const;
    bool piece(const geom::Frame& a, Posture from, const geom::Frame& b, double begin, double end, int depth,
               Passing& p) const;

    const Carried& c_;
    const geom::Frame back_;
};

} // namespace filum::kinematics
