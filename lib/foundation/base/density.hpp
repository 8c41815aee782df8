// Limits on how densely lines, samples or triangles may be placed. They are checked before any work begins.
#pragma once

#include "base/error.hpp"

#include <string>
#include <string_view>

namespace filum {

// The largest number of squares, as wide as the spacing, that an area may hold. Time and memory of a program that
// places lines, samples or triangles grow with this number. A square metre at 0.4 mm holds 6 million squares.
inline constexpr double kMostSquares = 1e7;

// A positive value as text with two digits, rounded up, so that it still satisfies a lower limit when it is typed.
std::string rounded_up(double value);

// Throws Error(exit) if `area` mm2 hold more than kMostSquares squares of side `spacing` mm. Throws it too if the
// spacing is not a positive number. `subject` names the value in the message: "--spacing".
void check_density(double area, double spacing, Exit exit, std::string_view subject);

// The smallest spacing of lines, as a share of the width of their beads. Closer beads would overlap too much.
inline constexpr double kLeastSpacing = 0.5;

// Throws Error(exit) if lines `spacing` mm apart are closer than kLeastSpacing of the `width` of their beads, mm.
void check_spacing(double spacing, double width, Exit exit, std::string_view subject);

} // namespace filum
