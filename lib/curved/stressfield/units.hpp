// Units in the names of columns and arrays, and their factors to mm and MPa; private to lib/curved/stressfield.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace filum::stressfield {

enum class Dimension { length, stress };

// The factor of a unit: "mm", "N/mm^2", "ksi". Nothing if it is not a unit of this dimension. "mPa" is rejected: it
// means a thousandth of a Pa, and is usually a mistake for MPa.
std::optional<double> factor_of(Dimension dimension, std::string_view unit);

// The text in the brackets of a name, "SXX [MPa]", "S11 (N/mm^2 (MPa))", or a known unit as its last word, "Sxx_MPa";
// "" if there is none.
std::string unit_in(Dimension dimension, std::string_view name);

// The name without a known unit as its last word: "Sxx" of "Sxx_MPa".
std::string_view without_unit(std::string_view name);

} // namespace filum::stressfield
