#include "macro/cursor.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace filum::macro {

namespace {

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_name(char c) { return begins_name(c) || (c >= '0' && c <= '9'); }

} // namespace

bool is_keyword(std::string_view word) {
    constexpr std::array<std::string_view, 13> kWords{"and",   "or",    "not",  "if",    "then",   "elsif", "else",
                                                      "endif", "false", "true", "local", "global", "repeat"};
    return std::ranges::find(kWords, word) != kWords.end();
}

void Cursor::blanks() {
    while (!done() && (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r')) ++at_;
}

bool Cursor::take(std::string_view sign) {
    blanks();
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
}

void Cursor::need(char sign, const char* what) {
    if (!take({&sign, 1})) fail(std::string("'") + sign + "' is missing " + what);
}

std::string Cursor::peek_name() {
    blanks();
    std::size_t end = at_;
    if (!done() && begins_name(peek()))
        while (end < text_.size() && in_name(text_[end])) ++end;
    return std::string(text_.substr(at_, end - at_));
}

bool Cursor::take_word(std::string_view word) {
    if (peek_name() != word) return false;
    at_ += word.size();
    return true;
}

std::string Cursor::name(const char* what) {
    std::string out = peek_name();
    if (out.empty() || is_keyword(out)) fail(std::string("a name is missing ") + what);
    at_ += out.size();
    return out;
}

} // namespace filum::macro
