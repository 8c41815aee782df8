// Units of length by their names, for options, mesh files and tables of stresses.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace filum {

inline constexpr double kInch = 25.4, kFoot = 304.8, kMetre = 1000; // mm

struct LengthUnit {
    // the symbol "mm", and the word of the 3MF standard, "millimeter"
    std::string_view symbol, word;
    double mm = 1;
    std::array<std::string_view, 4> others{}; // other spellings, in lower case
};

inline constexpr LengthUnit kLengthUnits[] = {{"um", "micron", 0.001, {"microns", "\xc2\xb5m", "\xce\xbcm"}},
                                              {"mm", "millimeter", 1, {"millimeters", "millimetre", "millimetres"}},
                                              {"cm", "centimeter", 10, {"centimeters", "centimetre", "centimetres"}},
                                              {"dm", "decimeter", 100, {"decimeters", "decimetre", "decimetres"}},
                                              {"m", "meter", kMetre, {"meters", "metre", "metres"}},
                                              {"mil", "mil", kInch / 1000, {"mils"}},
                                              {"in", "inch", kInch, {"inches"}},
                                              {"ft", "foot", kFoot, {"feet"}}};

// The length in mm of the unit with that symbol, with that word, or with any of its names. None if there is no such
// unit.
constexpr std::optional<double> length_of_symbol(std::string_view symbol) {
    for (const LengthUnit& u : kLengthUnits)
        if (u.symbol == symbol) return u.mm;
    return std::nullopt;
}
constexpr std::optional<double> length_of_word(std::string_view word) {
    for (const LengthUnit& u : kLengthUnits)
        if (u.word == word) return u.mm;
    return std::nullopt;
}
constexpr std::optional<double> length_of_name(std::string_view name) {
    if (name.empty()) return std::nullopt;
    for (const LengthUnit& u : kLengthUnits)
        if (u.symbol == name || u.word == name || std::ranges::find(u.others, name) != u.others.end()) return u.mm;
    return std::nullopt;
}

} // namespace filum
