#include "machine/toml_text.hpp"

#include "base/error.hpp"
#include "base/printable.hpp"
#include "machine/set_items.hpp"

#include <toml.hpp>

#include <algorithm>
#include <sstream>

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

// Throws what the library cannot take.
void check(std::string_view text, const std::string& failed) {
    if (depth(text) > kDeepest)
        throw Error(Exit::bad_input, failed + ": more than " + std::to_string(kDeepest) + " brackets are open at once");
    if (const std::size_t line = line_of_no_utf8(text); line > 0)
        throw Error(Exit::bad_input, failed + ", line " + std::to_string(line) + ": a byte that is not UTF-8");
}

// toml11 3.7 (Debian 12) and 4 (Debian 13) name these differently.
template <class Location>
std::size_t line_number(const Location& at) {
    if constexpr (requires { at.line(); })
        return at.line();
    else
        return at.first_line_number();
}
template <class Location>
std::string first_line(const Location& at) {
    if constexpr (requires { at.line_str(); })
        return at.line_str();
    else
        return at.lines().empty() ? "" : at.lines().front();
}
template <class Text>
const std::string& plain(const Text& text) {
    if constexpr (requires { text.str; })
        return text.str;
    else
        return text;
}
template <class Failure>
std::size_t line_of_failure(const Failure& e) {
    if constexpr (requires { e.location(); })
        return line_number(e.location());
    else
        return e.errors().empty() || e.errors()[0].locations().empty()
                   ? 0
                   : line_number(e.errors()[0].locations()[0].first);
}

std::size_t line_of(const toml::value& from) {
    const auto at = from.location();
    std::string text = first_line(at);
    while (text.ends_with('\r')) text.pop_back();
    const bool below = from.is_string() && (text.ends_with("\"\"\"") || text.ends_with("'''"));
    return line_number(at) + (below ? 1 : 0);
}

TomlValue converted(const toml::value& from) {
    TomlValue out{{}, from.location().file_name(), line_of(from)};
    if (from.is_boolean()) out.value = from.as_boolean();
    if (from.is_integer()) out.value = static_cast<std::int64_t>(from.as_integer());
    if (from.is_floating()) out.value = static_cast<double>(from.as_floating());
    if (from.is_string()) out.value = plain(from.as_string());
    if (from.is_array()) {
        TomlValue::List items;
        for (const auto& item : from.as_array()) items.push_back(converted(item));
        out.value = std::move(items);
    }
    if (from.is_table()) {
        TomlValue::Table table;
        for (const auto& [key, value] : from.as_table()) table.emplace(key, converted(value));
        out.value = std::move(table);
    }
    return out;
}

} // namespace

TomlValue::Table read_toml(std::string_view text, const std::string& file, const std::string& failed) {
    check(text, failed);
    try {
        std::istringstream in{std::string(text)};
        const auto root = toml::parse(in, file);
        TomlValue::Table out;
        for (const auto& [key, value] : root.as_table()) out.emplace(key, converted(value));
        return out;
    } catch (const toml::syntax_error& e) {
        std::string why = e.what();
        why = why.substr(0, why.find('\n'));
        if (why.starts_with("[error] ")) why = why.substr(8);
        if (why.starts_with("toml::")) why = why.substr(std::min(why.find(": "), why.size() - 2) + 2);
        throw Error(Exit::bad_input, failed + ", line " + std::to_string(line_of_failure(e)) + ": " + shown(why));
    } catch (const std::exception&) { // out of a number's range
        throw Error(Exit::bad_input, failed + ": it is no TOML");
    }
}

} // namespace filum::machine
