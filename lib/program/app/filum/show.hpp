// Prints text of the front command on standard output.
#pragma once

#include <string>

namespace filum::app::filum {

void show(const std::string& text);

// The text, padded with blanks to `width` characters; at least two blanks follow it.
std::string cell(std::string text, std::size_t width);

} // namespace filum::app::filum
