// Words of a POSIX shell's command line.
#pragma once

#include <string>

namespace filum {

// `text` as one word: in single quotes, unless it needs none.
std::string shell_word(const std::string& text);

} // namespace filum
