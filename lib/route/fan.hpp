// The stances between two of them: across from one to the other, aside, and back along the tool's own axis.
#pragma once

#include "collision/room.hpp"

#include <optional>
#include <vector>

namespace filum::route {

using collision::Stance;
using geom::Vec3;

// Where on a fan.
struct Knot {
    double share = 0; // of the way across; beyond 0 and 1 the axis stays as at the ends
    double aside = 0; // mm, across the way and the axis
    double rise = 0;  // mm, along the axis there
};

// The chord between two stances, on which the axis turns evenly.  A head widens upwards and has no end, so it has room
// at any greater rise where it has room at one: what must not be passed below is a surface over the fan.
class Fan {
  public:
    // `before`: beads born earlier stand in the way; the room is referred to.
    Fan(const collision::Room& room, const Stance& from, const Stance& to, std::uint32_t before);

    [[nodiscard]] Stance at(const Knot& knot) const;
    [[nodiscard]] double chord() const { return length_; } // mm
    [[nodiscard]] bool free(const Knot& knot) const { return room_->at(at(knot), before_); }
    // The share of the straight move from one knot to another where something first stands in its way.
    [[nodiscard]] std::optional<double> blocked(const Knot& a, const Knot& b) const;
    [[nodiscard]] double distance(const Knot& a, const Knot& b) const { return geom::distance(at(a).tip, at(b).tip); }

    // The least rise at the knot's place, no less than the knot's, at which there is room; to 0.05 mm, never too small.
    // 4096 mm if there is none below.
    [[nodiscard]] double least_rise(Knot knot) const;

  private:
    const collision::Room* room_;
    collision::Move chord_;
    Vec3 side_;
    double length_ = 0;
    std::uint32_t before_ = 0;
};

// Knots one behind the other.
using Way = std::vector<Knot>;
double length(const Fan& fan, const Way& way);

} // namespace filum::route
