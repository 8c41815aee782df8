#include "machine/pauses.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

namespace filum::machine {

bool Pause::before(std::uint32_t layer, double z, double height) const {
    constexpr double rounding = 1e-6; // mm, rounding error of the heights of layers
    return by_height ? at < z - height / 2 - rounding : at <= layer;
}

std::size_t Pauses::before(std::uint32_t layer, double z, double height) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [&](const Pause& p) { return p.before(layer, z, height); }));
}

Pauses parse_pauses(const std::string& text) {
    Pauses out;
    std::istringstream words(text);
    constexpr std::string_view colour = ":colour";
    for (std::string word; std::getline(words, word, ',');) {
        Pause pause;
        std::string number = word;
        if (number.ends_with(colour)) {
            pause.what = Pause::Kind::colour;
            number.resize(number.size() - colour.size());
        }
        pause.by_height = number.ends_with("mm");
        if (pause.by_height) number.resize(number.size() - 2);
        pause.at = parse_number(number, "--pause-at");
        const bool whole = pause.at == std::floor(pause.at) && pause.at < 1e9;
        if (!(pause.at > 0) || (!pause.by_height && !whole))
            throw Error(Exit::usage, "cannot use '" + word +
                                         "' for --pause-at: it must be a layer above 0, as 12, or a height, as 2.4mm; "
                                         "with ':colour' behind it, the filament is changed there");
        out.all.push_back(pause);
    }
    return out;
}

} // namespace filum::machine
