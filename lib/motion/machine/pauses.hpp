// Pauses of a print, where it waits for its user: before layers, or above heights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace filum::machine {

struct Pause {
    enum class Kind : std::uint8_t { wait, colour };
    Kind what = Kind::wait;
    bool by_height = false;
    // The number of the layer before which it is, counted from 0. By height, mm: it is before the first layer whose
    // middle is above.
    double at = 0;

    // Whether it comes before a layer whose top is at `z` and whose thickness is `height`, mm.
    [[nodiscard]] bool before(std::uint32_t layer, double z, double height) const;
};

struct Pauses {
    std::vector<Pause> all;

    [[nodiscard]] std::size_t count() const { return all.size(); }
    // The number of pauses before a layer whose top is at `z` and whose thickness is `height`, mm.
    [[nodiscard]] std::size_t before(std::uint32_t layer, double z, double height) const;
};

// Parses "12,2.4mm,5mm:colour": a number with "mm" is a height, a number without it is a layer; ":colour" asks for
// another filament.  Throws Error(usage) for any other text, and for layer 0 or a height of 0 or less, as nothing is
// printed before these.
Pauses parse_pauses(const std::string& text);

} // namespace filum::machine
