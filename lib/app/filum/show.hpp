// Text of the front command's own commands on standard output.
#pragma once

#include <string>

namespace filum::app::filum {

void show(const std::string& text);

// The text, left-aligned in a column of that width, and two blanks at least.
std::string cell(std::string text, std::size_t width);

} // namespace filum::app::filum
