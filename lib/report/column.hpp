// Columns of whole numbers, packed for a page.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace filum::report {

// The numbers as text: differences of neighbours, signs folded into the lowest bit, their four bytes apart, by zlib, in
// base 64.  page/data.js reads it.  Differences are taken modulo 2^32.
std::string packed(std::span<const std::int32_t> numbers);

} // namespace filum::report
