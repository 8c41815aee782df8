// Encodes bytes as text.
#pragma once

#include <span>
#include <string>

namespace filum {

// The bytes in base 64 (RFC 4648), padded with '=' to a multiple of four letters, without line breaks.
std::string base64(std::span<const unsigned char> bytes);

} // namespace filum
