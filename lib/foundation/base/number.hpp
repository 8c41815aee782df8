// Converts numbers to text and back, independent of the locale. Text never has an exponent.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filum {

// `value` with `decimals` digits after the point, trailing zeros removed, "0" for minus zero.  Precondition: finite.
std::string fixed_text(double value, int decimals);

// Appends the text of fixed_text to `out` without allocating; the inner loop of every text writer.
void append_fixed(std::string& out, double value, int decimals);

// The shortest text that reads back as the same value.
std::string shortest_text(double value);

// The number that `text` holds. Throws Error(usage), naming `what`, if the whole text is not one finite number.
double parse_number(std::string_view text, std::string_view what);

// The pairs of "NAME=NUMBER,...", in the order of the text. Numbers must be finite and not negative. Throws
// Error(usage) naming the option `what`.
std::vector<std::pair<std::string, double>> parse_weights(std::string_view words, const std::string& what);

} // namespace filum
