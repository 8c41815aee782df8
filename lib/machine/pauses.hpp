// Where a print is to wait for its user: before layers, or above heights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace filum::machine {

struct Pauses {
    std::vector<std::uint32_t> layers; // before each of these, counted from 0
    std::vector<double> heights;       // mm: before the first layer of which more than half lies above

    [[nodiscard]] std::size_t count() const { return layers.size() + heights.size(); }
    // How many of them come before a layer whose top is at z.
    [[nodiscard]] std::size_t before(std::uint32_t layer, double z, double height) const;
};

// "12,2.4mm": a number with "mm" is a height, one without a layer.  Throws Error(usage) for anything else, and for
// layer 0 or a height that is not above 0, before which there is nothing.
Pauses parse_pauses(const std::string& text);

} // namespace filum::machine
