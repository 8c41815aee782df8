// The fan by layer: [cooling] of a profile.
#pragma once

#include "machine/reader.hpp"

#include <cstdint>

namespace filum::machine {

// Fan speeds, in the machine's own unit.
struct Cooling {
    double most = -1;   // on layers that take less than `fast`; -1: the templates set the fan
    double least = 0;   // on layers that take just less than `below`
    double idle = 0;    // on layers that take `below` or longer
    double bridge = -1; // on bridges, if it is faster than on the rest of the layer
    double fast = 0;    // s
    double below = 0;   // s; from `fast` to `below` the speed changes linearly from most to least
    int off_layers = 1; // number of first layers without fan
    int full_layer = 0; // the speed rises linearly up to this layer, counted from 1

    [[nodiscard]] bool active() const { return most >= 0; }
    // The speed on a layer, counted from 0, that takes `seconds`: in general, and on its bridges.
    [[nodiscard]] double speed(std::uint32_t layer, double seconds) const;
    [[nodiscard]] double bridge_speed(std::uint32_t layer, double seconds) const {
        return raised(layer, seconds, bridge);
    }
    // The speed on such a layer where it should be `wanted` at least.  On layers on which the speed rises, `wanted`
    // rises, too.
    [[nodiscard]] double raised(std::uint32_t layer, double seconds, double wanted) const;

  private:
    [[nodiscard]] double share(std::uint32_t layer) const; // of the full speed
};

void read_cooling(Document& doc, Cooling& cooling);

} // namespace filum::machine
