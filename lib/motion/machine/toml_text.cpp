#include "machine/toml_text.hpp"

#include "base/error.hpp"
#include "base/printable.hpp"

#include <algorithm>

namespace filum::machine {

namespace {

// Values nested deeper than this are refused, since the parser calls itself once for each level.
constexpr int kDeepest = 100;

// The number of brackets and braces that are open at once, at most; those in texts and comments count, too.
int depth(std::string_view text) {
    int open = 0, most = 0;
    for (const char c : text) {
        if (c == '[' || c == '{') most = std::max(most, ++open);
        if ((c == ']' || c == '}') && open > 0) --open;
    }
    return most;
}

// The line, counted from 1, of the first byte that is not UTF-8; 0 if there is none.  toml11 3.7 reads past the end of
// a quoted text with such a byte.
std::size_t line_of_no_utf8(std::string_view text) {
    std::size_t line = 1;
    while (!text.empty()) {
        const std::size_t length = utf8_character(text);
        if (length == 0) return line;
        line += text.front() == '\n' ? 1 : 0;
        text.remove_prefix(length);
    }
    return 0;
}

} // namespace

void check_toml(std::string_view text, const std::string& failed) {
    if (depth(text) > kDeepest)
        throw Error(Exit::bad_input, failed + ": more than " + std::to_string(kDeepest) + " brackets are open at once");
    if (const std::size_t line = line_of_no_utf8(text); line > 0)
        throw Error(Exit::bad_input, failed + ", line " + std::to_string(line) + ": a byte that is not UTF-8");
}

} // namespace filum::machine
