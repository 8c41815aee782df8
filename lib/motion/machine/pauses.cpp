#include "machine/pauses.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace filum::machine {

std::size_t Pauses::before(std::uint32_t layer, double z, double height) const {
    const auto in_layers = std::count_if(layers.begin(), layers.end(), [&](std::uint32_t l) { return l <= layer; });
    constexpr double rounding = 1e-6; // mm, rounding error of the heights of layers
    const auto in_heights =
        std::count_if(heights.begin(), heights.end(), [&](double h) { return h < z - height / 2 - rounding; });
    return static_cast<std::size_t>(in_layers + in_heights);
}

Pauses parse_pauses(const std::string& text) {
    Pauses out;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const bool height = word.ends_with("mm");
        const double value = parse_number(height ? word.substr(0, word.size() - 2) : word, "--pause-at");
        const bool whole = value == std::floor(value) && value < 1e9;
        if (!(value > 0) || (!height && !whole))
            throw Error(Exit::usage, "cannot use '" + word +
                                         "' for --pause-at: it must be a layer above 0, as 12, or a height, as 2.4mm");
        if (height)
            out.heights.push_back(value);
        else
            out.layers.push_back(static_cast<std::uint32_t>(value));
    }
    return out;
}

} // namespace filum::machine
