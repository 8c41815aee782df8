// Text as JSON.
#pragma once

#include <string>
#include <string_view>

namespace filum {

// A JSON string in quotes.  What is no UTF-8 passes as it is.
std::string json_text(std::string_view text);

} // namespace filum
