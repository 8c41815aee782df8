// Bytes as text.
#pragma once

#include <span>
#include <string>

namespace filum {

// RFC 4648, with '=' to a multiple of four letters, without line ends.
std::string base64(std::span<const unsigned char> bytes);

} // namespace filum
