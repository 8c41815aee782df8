#include "base/printable.hpp"

#include <cstdint>

namespace filum {

namespace {

// The length of the UTF-8 character at the start of `text`, which is not empty, and its code; 0: it is none.
std::size_t character(std::string_view text, std::uint32_t& code) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80              ? 1
                               : (first & 0xe0U) == 0xc0 ? 2
                               : (first & 0xf0U) == 0xe0 ? 3
                               : (first & 0xf8U) == 0xf0 ? 4
                                                         : 0;
    if (length == 0 || length > text.size()) return 0;
    constexpr std::uint32_t kMask[] = {0, 0x7f, 0x1f, 0x0f, 0x07}, kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    code = first & kMask[length];
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) return 0;
        code = code << 6U | (byte(i) & 0x3fU);
    }
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < kLeast[length] || code > 0x10ffff || surrogate ? 0 : length;
}

bool is_control(std::uint32_t code) {
    const bool c0 = code < 0x20 || code == 0x7f, c1 = code >= 0x80 && code < 0xa0;
    const bool separator = code == 0x2028 || code == 0x2029;
    const bool turns = code == 0x200e || code == 0x200f || code == 0x61c || (code >= 0x202a && code <= 0x202e) ||
                       (code >= 0x2066 && code <= 0x2069);
    return c0 || c1 || separator || turns;
}

void escape(unsigned char byte, std::string& out) {
    constexpr const char* kHex = "0123456789abcdef";
    if (byte == '\n')
        out += "\\n";
    else if (byte == '\t')
        out += "\\t";
    else if (byte == '\r')
        out += "\\r";
    else
        out += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
}

} // namespace

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    while (!text.empty()) {
        std::uint32_t code = 0;
        const std::size_t length = character(text, code);
        const std::size_t taken = length == 0 ? 1 : length;
        if (length > 0 && !is_control(code))
            out += text.substr(0, taken);
        else
            for (const char c : text.substr(0, taken)) escape(static_cast<unsigned char>(c), out);
        text.remove_prefix(taken);
    }
    return out;
}

} // namespace filum
