// Whether the head has room at a stance and along a move.
#pragma once

#include "collision/check.hpp"

#include <optional>

namespace filum::collision {

// Applies the criteria of check(), but stops at the first obstacle and is conservative: where there is room, check()
// finds no collision, however it divides the move.
class Room {
  public:
    // The arguments must outlive the object. Except from beads the head keeps `more` mm more than the margin.
    Room(const Scene& scene, const Shape& shape, const Options& options, double more = 0);

    // Whether the head has room at the stance, with the beads born earlier than `before`.
    [[nodiscard]] bool at(const ToolFrame& stance, std::uint32_t before) const;

    // The share of the move at which something first blocks it, approximately; none if nothing does. Obstacles within
    // 0.01 mm of the margin may count as blocking.
    [[nodiscard]] std::optional<double> blocked(const Move& move) const;

  private:
    [[nodiscard]] Probe probe(const ToolFrame& stance, std::uint32_t before, std::size_t kind) const;

    const Scene* scene_;
    const Shape* shape_;
    const Options* options_;
    double more_;
};

// The rooms of all tools' heads; the references must stay valid.
struct Rooms {
    const Scene& scene;
    const Shapes& shapes;
    const Options& options;
    double more = 0;
    [[nodiscard]] Room of(std::uint32_t tool) const { return {scene, shapes.of(tool), options, more}; }
};

} // namespace filum::collision
