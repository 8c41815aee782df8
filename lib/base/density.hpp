// The one limit on how densely lines may lie: an estimate of what would be laid, made before any work.
#pragma once

#include "base/error.hpp"

#include <string>
#include <string_view>

namespace filum {

// A program that places lines, samples or triangles at a spacing needs time and memory that grow with the number of
// squares of that side in the area.  A square metre at 0.4 mm holds 6 million.
inline constexpr double kMostSquares = 1e7;

// The text of a positive value to two digits, rounded up: a least value that holds when it is typed.
std::string rounded_up(double value);

// Throws Error(exit) if `area` mm2 hold more than kMostSquares squares of side `spacing` mm, or the spacing is no
// positive number.  `subject` names the value in the message: "--spacing".
void check_density(double area, double spacing, Exit exit, std::string_view subject);

// Beads closer than this share of their width would lie one on the other.
inline constexpr double kLeastSpacing = 0.5;

// Throws Error(exit) if lines `spacing` mm apart are closer than kLeastSpacing of the `width` of their beads, mm.
void check_spacing(double spacing, double width, Exit exit, std::string_view subject);

} // namespace filum
