// Evaluates the formulas of Cura: expressions of Python over settings.
#pragma once

#include "app/filum/cura_value.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace filum::app::filum {

// The value of a formula without its '='.  The formula may use numbers, texts, lists, names of settings, + - * / // %
// **, comparisons, in, and, or, not, `x if c else y`; abs, all, any, bool, float, int, len, max, min, round, str, sum;
// ceil, floor, sqrt, sines, arcs and pi of `math`; and Cura's own resolveOrValue, extruderValue, extruderValues and
// defaultExtruderPosition for a print with one extruder.  They have Python's meaning.
// `setting` gives the value of a name.  A part that cannot be calculated matters only if the result depends on it.
// MissingValue: bad syntax, another function, a wrong type, a division by zero, a result beyond all bounds.
CuraValue calculated(std::string_view formula, const std::function<CuraValue(const std::string&)>& setting);

} // namespace filum::app::filum
