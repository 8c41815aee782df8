// Quotes words for the command line of a POSIX shell.
#pragma once

#include <string>

namespace filum {

// `text` as one word of the command line, in single quotes unless it needs none.
std::string shell_word(const std::string& text);

} // namespace filum
