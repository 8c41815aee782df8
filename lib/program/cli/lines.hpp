// Breaks text into lines.
#pragma once

#include <cstddef>
#include <string>

namespace filum::cli {

// The text in lines of at most `width` characters, broken at blanks; a longer word has a line of its own.  Each line
// but the first begins with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width);

// A line for standard error: if that is a terminal, it is broken at the terminal's width, else it stays whole.
std::string for_terminal(const std::string& line);

} // namespace filum::cli
