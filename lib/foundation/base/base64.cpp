#include "base/base64.hpp"

#include <cstdint>

namespace filum {

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

} // namespace filum
