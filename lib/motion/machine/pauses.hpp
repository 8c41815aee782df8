// Pauses of a print, where it waits for its user: before layers, or above heights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace filum::machine {

struct Pauses {
    std::vector<std::uint32_t> layers; // a pause before each of these layers, counted from 0
    std::vector<double> heights;       // mm: a pause before the first layer whose middle is above

    [[nodiscard]] std::size_t count() const { return layers.size() + heights.size(); }
    // The number of pauses before a layer whose top is at `z` and whose thickness is `height`, mm.
    [[nodiscard]] std::size_t before(std::uint32_t layer, double z, double height) const;
};

// Parses "12,2.4mm": a number with "mm" is a height, a number without it is a layer.  Throws Error(usage) for any other
// text, and for layer 0 or a height of 0 or less, as nothing is printed before these.
Pauses parse_pauses(const std::string& text);

} // namespace filum::machine
