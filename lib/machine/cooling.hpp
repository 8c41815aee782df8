// The fan by layer: [cooling] of a profile.
#pragma once

#include "machine/reader.hpp"

#include <cstdint>

namespace filum::machine {

// Speeds as the machine counts them.
struct Cooling {
    double most = -1;   // on layers that take less than `fast` seconds; -1: the templates set the fan
    double least = 0;   // on layers that take `below` seconds
    double idle = 0;    // on layers that take longer
    double bridge = -1; // of beads that are bridges, if it is faster than on the rest of the layer
    double fast = 0;    // s
    double below = 0;   // s; between both times the speed changes with the time in proportion
    int off_layers = 1; // the first ones, which have no fan
    int full_layer = 0; // up to this layer, counted from 1, the speed rises in proportion

    [[nodiscard]] bool active() const { return most >= 0; }
    // The speed on a layer, counted from 0, that takes so many seconds.
    [[nodiscard]] double speed(std::uint32_t layer, double seconds) const;
    [[nodiscard]] double bridge_speed(std::uint32_t layer, double seconds) const;

  private:
    [[nodiscard]] double share(std::uint32_t layer) const; // of the full speed
};

void read_cooling(Document& doc, Cooling& cooling);

} // namespace filum::machine
