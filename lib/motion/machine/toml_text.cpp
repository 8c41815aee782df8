#include "machine/toml_text.hpp"

#include <algorithm>

namespace filum::machine {

namespace {

bool begins_key(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '"' || c == '\'';
}

// True if `rest`, which begins with '[', begins a section or a list of sections that has a name.
bool names_section(std::string_view rest) {
    rest.remove_prefix(rest.substr(0, 2) == "[[" ? 2 : 1);
    const auto name = rest.find_first_not_of(" \t");
    return name != std::string_view::npos && begins_key(rest[name]);
}

// The end of the quoted text or comment that begins at `at`: one past its last character.
std::size_t end_of_quiet(std::string_view text, std::size_t at) {
    const char quote = text[at];
    if (quote == '#') return std::min(text.find('\n', at), text.size());
    const std::string three(3, quote);
    const bool several_lines = text.substr(at, 3) == three;
    for (std::size_t i = at + (several_lines ? 3 : 1); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"')
            ++i;
        else if (several_lines && text.substr(i, 3) == three) {
            i += 3;
            for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i; // up to two belong to it
            return i;
        } else if (!several_lines && (text[i] == quote || text[i] == '\n'))
            return i + (text[i] == quote ? 1 : 0);
    }
    return text.size();
}

// True if `quoted` is a text of several lines whose first line is empty, so that it begins on the next one.
bool opens_lines(std::string_view quoted) {
    return (quoted.starts_with("\"\"\"") || quoted.starts_with("'''")) &&
           (quoted.substr(3).starts_with('\n') || quoted.substr(3).starts_with("\r\n"));
}

bool is_control(char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7f;
}

} // namespace

TomlText examine(std::string_view text) {
    TomlText out;
    std::size_t line = 1;
    const auto fault = [&](const char* why) {
        if (out.fault.empty()) {
            out.fault = why;
            out.line = line;
        }
    };
    bool fresh = true; // only blanks on this line so far
    for (std::size_t i = text.starts_with("\xef\xbb\xbf") ? 3 : 0; i < text.size();) {
        const char c = text[i];
        if (c == '#' || c == '"' || c == '\'') {
            const auto quiet = text.substr(i, end_of_quiet(text, i) - i);
            if (opens_lines(quiet)) {
                out.opens.resize(line);
                out.opens.back() = true;
            }
            for (const char q : quiet) {
                if (is_control(q)) fault("a control character");
                line += q == '\n' ? 1 : 0;
            }
            i += quiet.size();
            fresh = false;
            continue;
        }
        if (fresh && c == '[' && !names_section(text.substr(i))) fault("a section without a name");
        if (static_cast<unsigned char>(c) >= 0x80) fault("a letter beyond ASCII outside of quotes and comments");
        if (is_control(c)) fault("a control character");
        fresh = c == '\n' || (fresh && (c == ' ' || c == '\t'));
        line += c == '\n' ? 1 : 0;
        ++i;
    }
    return out;
}

} // namespace filum::machine
