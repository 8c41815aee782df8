#include "base/printable.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace filum {

namespace {

// The length in bytes of the UTF-8 character at the start of `text`, which must not be empty; sets `code` to its
// number. 0 if `text` does not start with UTF-8.
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
    const bool none = (code & 0xfffeU) == 0xfffe || (code >= 0xfdd0 && code <= 0xfdef);
    return c0 || c1 || separator || turns || none;
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
    if (std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; })) return std::string(text);
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

std::size_t utf8_character(std::string_view text) {
    std::uint32_t code = 0;
    return text.empty() ? 0 : character(text, code);
}

std::string plain_word(std::string_view text, std::string_view otherwise) {
    constexpr std::size_t kLongest = 64;
    std::string out(text.substr(0, kLongest));
    for (char& c : out) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (!letter && !(c >= '0' && c <= '9') && c != '-') c = '_';
    }
    return out.empty() ? std::string(otherwise) : out;
}

std::vector<std::string> told_apart(const std::vector<std::string>& words) {
    std::vector<std::string> out;
    std::map<std::string, std::size_t> seen;
    for (const std::string& word : words) {
        std::string name = word;
        for (std::size_t n = ++seen[word]; n > 1; n = ++seen[word]) {
            name = word + "_" + std::to_string(n);
            if (seen.emplace(name, 1).second) break;
        }
        out.push_back(name);
    }
    return out;
}

} // namespace filum
