// One straight move of an arm.
#pragma once

#include "kinematics/follow.hpp"

namespace filum::kinematics {

// The result of a move.
struct JointMove {
    Posture to{};
    double needed = 0; // s
    std::size_t axis = 0;
    Nearness nearest{Singular::wrist, 10};
    double room = std::numeric_limits<double>::infinity(); // rad from an axis' limit; negative: beyond
    std::size_t room_axis = 0;
    Hindrance hindrance;
};

class Follower {
  public:
    // it refers to `carried`
    explicit Follower(const ArmSetup& carried) : c_(carried), back_(geom::inverse(carried.tool)) {}

    // Updates `p` by the distances of a posture from limits and singularities.
    void look(const Posture& q, JointMove& p) const;

    // Moves straight from `a`, where the posture is `from`, to `b`; `to` of the result is the last posture reached.
    [[nodiscard]] JointMove pass(const geom::Frame& a, const Posture& from, const geom::Frame& b) const;

    [[nodiscard]] std::vector<Posture> ways(const geom::Frame& tip, const Posture& near, Shortfall* lack) const;

  private:
    [[nodiscard]] std::optional<Posture> on(const geom::Frame& tip, const Posture& near, JointMove& p) const;
    bool piece(const geom::Frame& a, Posture from, const geom::Frame& b, double begin, double end, int depth,
               JointMove& p) const;

    const ArmSetup& c_;
    const geom::Frame back_;
};

} // namespace filum::kinematics
