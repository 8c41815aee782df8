#include "report/column.hpp"

#include "base/error.hpp"

#include <vector>
#include <zlib.h>

namespace filum::report {

namespace {

constexpr int kEffort = 4; // of zlib: more takes twice the time for a twentieth of the size

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

std::string base64(std::span<const unsigned char> bytes) {
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = bytes.size() - i;
        const std::uint32_t three = (std::uint32_t{bytes[i]} << 16) |
                                    (left > 1 ? std::uint32_t{bytes[i + 1]} << 8 : 0) |
                                    (left > 2 ? std::uint32_t{bytes[i + 2]} : 0);
        out += letters[three >> 18];
        out += letters[three >> 12 & 63];
        out += left > 1 ? letters[three >> 6 & 63] : '=';
        out += left > 2 ? letters[three & 63] : '=';
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
