// CRC-32C (Castagnoli), the checksum of the end frame.
#pragma once

#include <cstddef>
#include <cstdint>

namespace filum::stream {

// The checksum of the bytes so far, `crc`, carried on over `size` bytes more; start with 0.
std::uint32_t crc32c(std::uint32_t crc, const void* data, std::size_t size);

} // namespace filum::stream
