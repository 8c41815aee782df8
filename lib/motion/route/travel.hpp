// The way of the head from the end of a stroke to the start of the next one (docs/algorithms/routing.md#travels).
#pragma once

#include "route/fan.hpp"

#include <array>

namespace filum::route {

enum class Kind : std::uint8_t {
    straight, // at the least rise
    over,     // higher than that
    around,   // past obstacles
};
inline constexpr std::array<const char*, 3> kKindNames{"straight", "over", "around"};

struct TravelOptions {
    double lift = 0.6;      // mm along the tool axis before anything else
    double min_length = 0;  // mm; a shorter travel that is free is not raised
    double under = 0;       // mm that the tip keeps above what it passes over, except at both ends
    double most_turn = 0.1; // rad between two points: machines rotate in their own way in between
};

struct Travel {
    std::vector<ToolFrame> stances; // from the first to the last
    Kind kind = Kind::straight;
    double length = 0; // mm
    bool free = false; // the whole way
};

// Rises along the axis at `from` by at least the lift, crosses, and descends along the axis at `to`; the axis rotates
// only while crossing (the travels of D. Kipping et al. 2022, with a computed height). Takes the shortest free one of
// three ways:
// - straight, at the lift;
// - over: where that is blocked, corners are added above the place that rises most, at the least free rise plus the
//   lift (at least 0.2 mm), until all is free; then unnecessary corners are removed;
// - around: searched at four heights from the lift to that of the way over, if that exceeds the straight way by 5 mm
//   and a quarter.
// The way is found for a tip that is lower by `under`, and then raised by as much.
// `before`: beads born earlier are obstacles. If no way is free, the way over as far as it was found; from an end
// without room it first leads along the axis. Deterministic; a way over has at most 64 corners; see around.hpp for the
// other.
Travel travel(const collision::Room& room, const ToolFrame& from, const ToolFrame& to, std::uint32_t before,
              const TravelOptions& options);

} // namespace filum::route
