// Checks a TOML text before it is parsed.
#pragma once

#include <string>
#include <string_view>

namespace filum::machine {

// Throws Error(bad_input), beginning with `failed`, for a text that toml11 3.7 cannot take: with values nested deeper
// than 100 brackets, or with a byte that is not UTF-8.
void check_toml(std::string_view text, const std::string& failed);

} // namespace filum::machine
