// CRC-32C (Castagnoli), the checksum of the end frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace filum::stream {

// Continues the checksum `crc` of the bytes so far over `size` more bytes. Start with 0.
std::uint32_t crc32c(std::uint32_t crc, const void* data, std::size_t size);

// The checksum of `bytes` as eight hexadecimal digits. A history identifies a file by it.
std::string crc32c_text(std::string_view bytes);

} // namespace filum::stream
