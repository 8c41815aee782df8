// CRC-32C (Castagnoli), the checksum of the end frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace filum::stream {

// The checksum of the bytes so far, `crc`, carried on over `size` bytes more; start with 0.
std::uint32_t crc32c(std::uint32_t crc, const void* data, std::size_t size);

// That of all bytes as eight hexadecimal digits, by which a history knows a file.
std::string crc32c_text(std::string_view bytes);

} // namespace filum::stream
