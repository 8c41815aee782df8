#include "report/column.hpp"

#include "base/base64.hpp"
#include "base/error.hpp"

#include <vector>
#include <zlib.h>

namespace filum::report {

namespace {

constexpr int kEffort = 4; // level of zlib: a higher one takes twice the time and saves a twentieth of the size

std::vector<unsigned char> planes(std::span<const std::int32_t> numbers) {
    const std::size_t n = numbers.size();
    std::vector<unsigned char> out(4 * n);
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto value = static_cast<std::uint32_t>(numbers[i]);
        const std::uint32_t by = value - before;
        const std::uint32_t folded = (by << 1) ^ (by >> 31 != 0 ? UINT32_MAX : 0);
        for (std::size_t k = 0; k < 4; ++k) out[k * n + i] = static_cast<unsigned char>(folded >> (8 * k));
        before = value;
    }
    return out;
}

} // namespace

std::string packed(std::span<const std::int32_t> numbers) {
    const auto raw = planes(numbers);
    uLongf size = compressBound(raw.size());
    std::vector<unsigned char> small(size);
    if (compress2(small.data(), &size, raw.data(), raw.size(), kEffort) != Z_OK)
        throw Error(Exit::failure, "cannot pack the report: out of memory");
    return base64({small.data(), size});
}

} // namespace filum::report
