// The origin of a program's coordinates: G10 L2, G52, G54 to G59, G92.
#pragma once

#include "machine/codes.hpp"

#include <array>

namespace filum::ingest {

using machine::AxisNumbers;

// Positions are machine coordinates.  The home position is taken as 0, as programs do not state it.
class Origin {
  public:
    static constexpr std::size_t kSystems = 9; // G54 to G59, G59.1 to G59.3

    // The offset added to the number of an axis.
    [[nodiscard]] double of(std::size_t axis) const { return work_[system_][axis] + local_[axis] + zero_[axis]; }
    // Gives position `at` of an axis the coordinate `number` (G92).
    void name(std::size_t axis, double at, double number);
    void forget_names() { zero_ = {}; }
    void home(std::size_t axis) { zero_[axis] = 0; }
    void local(std::size_t axis, double offset) { local_[axis] = offset; }
    // work: G10 L2, sets the origin of a system.  work_name: G10 L20, gives position `at` the coordinate `number`.
    void work(std::size_t system, std::size_t axis, double offset);
    void work_name(std::size_t system, std::size_t axis, double at, double number);
    void use(std::size_t system) { system_ = system; }

    [[nodiscard]] std::size_t in_use() const { return system_; }
    [[nodiscard]] bool is_set(std::size_t system) const { return set_[system]; }

  private:
    std::array<AxisNumbers, kSystems> work_{};
    std::array<bool, kSystems> set_{};
    AxisNumbers local_{}, zero_{};
    std::size_t system_ = 0;
};

} // namespace filum::ingest
