// Heatshrink: LZSS compression for small processors, as binary G-code uses it. Bits are stored highest first. A 1 and
// eight bits are a byte. A 0 is a reference: `window_bits` bits for the distance back, less one, and `length_bits` bits
// for the length, less one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace filum::bgcode {

// Expands the first `size` bytes; none if the data ends too soon or refers to bytes before its start.
std::optional<std::string> expanded(std::string_view data, std::size_t size, int window_bits, int length_bits);

std::string shrunk(std::string_view data, int window_bits, int length_bits);

} // namespace filum::bgcode
