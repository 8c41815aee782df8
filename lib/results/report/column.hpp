// Packs columns of whole numbers for a page.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace filum::report {

// The numbers as text, which page/data.js reads: differences of neighbours modulo 2^32, with the sign moved to the
// lowest bit. The four bytes of each number are stored in four separate sequences, compressed by zlib and encoded in
// base 64.
std::string packed(std::span<const std::int32_t> numbers);

} // namespace filum::report
