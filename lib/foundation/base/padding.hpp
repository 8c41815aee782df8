// What stands behind the end of some text files.
#pragma once

#include <string_view>

namespace filum {

// The text without zeros and Control-Z at its end: some programs fill the last block of a file with zeros, and DOS
// ended texts with Control-Z.
inline std::string_view without_padding(std::string_view text) {
    while (!text.empty() && (text.back() == '\0' || text.back() == '\x1a')) text.remove_suffix(1);
    return text;
}

} // namespace filum
