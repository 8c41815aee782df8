// Whether the head has room: where it stands, and all along a move.
#pragma once

#include "collision/check.hpp"

#include <optional>

namespace filum::collision {

// Asks what check() asks, but stops at the first thing in the way, and for certain: where there is room, check() finds
// no collision, however it cuts the move.
class Room {
  public:
    // All three are referred to.  From what is no bead the head stays away by `more` mm than the margin.
    Room(const Scene& scene, const Shape& shape, const Options& options, double more = 0);

    // Whether the head may stand there, among the beads born earlier than `before`.
    [[nodiscard]] bool at(const Stance& stance, std::uint32_t before) const;

    // The share of the move, near enough, where something first stands in its way: nothing if nothing does.
    // What comes nearer to the margin than 0.01 mm while the head moves may count as in the way.
    [[nodiscard]] std::optional<double> blocked(const Move& move) const;

  private:
    [[nodiscard]] Probe probe(const Stance& stance, std::uint32_t before, std::size_t kind) const;

    const Scene* scene_;
    const Shape* shape_;
    const Options* options_;
    double more_;
};

// The same for each tool's head.  All that it is made of is referred to.
struct Rooms {
    const Scene& scene;
    const Shapes& shapes;
    const Options& options;
    double more = 0;
    [[nodiscard]] Room of(std::uint32_t tool) const { return {scene, shapes.of(tool), options, more}; }
};

} // namespace filum::collision
