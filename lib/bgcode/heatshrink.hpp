// Heatshrink: LZSS for small processors, as binary G-code uses it.  Bits come highest first.  1 and eight bits are a
// byte; 0, `window_bits` bits and `length_bits` bits are a distance back, less one, and a length, less one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace filum::bgcode {

// The first `size` bytes; nothing if the data ends before or points before its begin.
std::optional<std::string> expanded(std::string_view data, std::size_t size, int window_bits, int length_bits);

std::string shrunk(std::string_view data, int window_bits, int length_bits);

} // namespace filum::bgcode
