// One way of the head from where a stroke ends to where the next one begins (docs/algorithms/routing.md#travels).
#pragma once

#include "route/fan.hpp"

#include <array>

namespace filum::route {

enum class Kind : std::uint8_t {
    straight, // across at the least rise
    over,     // higher than that
    around,   // past what stands there
};
inline constexpr std::array<const char*, 3> kKindNames{"straight", "over", "around"};

struct TravelOptions {
    double lift = 0.6;      // mm along the tool's axis before anything else
    double min_length = 0;  // mm; a shorter one that is free stays where it is
    double most_turn = 0.1; // rad between two points: machines turn their own way in between
};

struct Travel {
    std::vector<Stance> stances; // from the first to the last
    Kind kind = Kind::straight;
    double length = 0; // mm
    bool free = false; // all of it
};

// Up along the axis at `from` by the lift at least, across, and down along the axis at `to`; the axis turns only on the
// way across (the 2022 paper's travels, D. Kipping et al., with the height found out).  Of three ways the shortest that
// is free:
// straight, at the lift;
// over: where that is blocked, corners are put above the place that rises most, at the least rise with room and the
// lift
//   more (0.2 mm at least), until all is free; then corners that are not needed go;
// around: at each of four heights from the lift to that of the way over, if that one costs more than 5 mm and a
//   quarter of the straight one.
// `before`: beads born earlier stand in the way.  If there is no free one, the way over, as far as it got; from an end
// without room it leads along the axis first.
// Deterministic; a way over has at most 64 corners, see around.hpp for the other.
Travel travel(const collision::Room& room, const Stance& from, const Stance& to, std::uint32_t before,
              const TravelOptions& options);

} // namespace filum::route
