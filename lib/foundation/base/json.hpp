// Writes text as JSON.
#pragma once

#include <string>
#include <string_view>

namespace filum {

// `text` as a JSON string in quotes. A byte that is not UTF-8 becomes U+FFFD, the replacement character.
std::string json_text(std::string_view text);

} // namespace filum
