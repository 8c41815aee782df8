#include "base/json.hpp"

#include "base/printable.hpp"

namespace filum {

std::string json_text(std::string_view text) {
    constexpr const char* hex = "0123456789abcdef";
    std::string out = "\"";
    while (!text.empty()) {
        const char c = text[0];
        const auto u = static_cast<unsigned char>(c);
        const std::size_t length = utf8_character(text);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (u < 0x20) {
            out += "\\u00";
            out += hex[u >> 4];
            out += hex[u & 15];
        } else if (length == 0) {
            out += "\\ufffd";
        } else {
            out += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out + "\"";
}

} // namespace filum
