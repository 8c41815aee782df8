// The stances around a straight way between two stances: on the way, to its sides, and raised along the tool axis.
#pragma once

#include "collision/room.hpp"

#include <optional>
#include <vector>

namespace filum::route {

using collision::ToolFrame;
using geom::Vec3;

// Coordinates on a fan.
struct Knot {
    double share = 0; // of the way; beyond 0 and 1 the axis stays as at the ends
    double aside = 0; // mm, perpendicular to the way and the axis
    double rise = 0;  // mm, along the axis there
};

// The chord between two stances, along which the axis rotates evenly. A head widens upwards without end, so if it has
// room at some rise it has room at any greater one: the least rise is a function over the fan.
class Fan {
  public:
    // `before`: beads born earlier are obstacles. `room` must outlive the object.
    Fan(const collision::Room& room, const ToolFrame& from, const ToolFrame& to, std::uint32_t before);

    [[nodiscard]] ToolFrame at(const Knot& knot) const;
    [[nodiscard]] double chord() const { return length_; } // mm
    [[nodiscard]] bool free(const Knot& knot) const { return room_->at(at(knot), before_); }
    // The share of the straight move from one knot to another at which it is first blocked.
    [[nodiscard]] std::optional<double> blocked(const Knot& a, const Knot& b) const;
    [[nodiscard]] double distance(const Knot& a, const Knot& b) const { return geom::distance(at(a).tip, at(b).tip); }

    // The least rise at the knot's place, at least the knot's, at which there is room; accurate to 0.05 mm, never too
    // small. 4096 mm if there is none below.
    [[nodiscard]] double least_rise(Knot knot) const;

  private:
    const collision::Room* room_;
    collision::Move chord_;
    Vec3 side_;
    double length_ = 0;
    std::uint32_t before_ = 0;
};

// A sequence of knots.
using Way = std::vector<Knot>;
double length(const Fan& fan, const Way& way);

} // namespace filum::route
