// Tables that a program carries as text: one row per line, tabs between cells.
#pragma once

#include <string_view>
#include <vector>

namespace filum {

// The text before the first `at`, or all of it. `from` keeps the text behind that character.
std::string_view cut(std::string_view& from, char at);

// The cells of every row. Empty lines and lines that begin with '#' are no rows, and a cell "-" is empty.
std::vector<std::vector<std::string_view>> table_rows(std::string_view text);

} // namespace filum
