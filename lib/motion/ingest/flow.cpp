#include "ingest/flow.hpp"

#include <cctype>
#include <cstdlib>

namespace filum::ingest {

namespace {

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The length of the line number "N10 " at the beginning.
std::size_t line_number(std::string_view code) {
    std::size_t i = 0;
    if (i < code.size() && upper(code[i]) == 'N') {
        ++i;
        while (i < code.size() && (is_digit(code[i]) || code[i] == ' ')) ++i;
    }
    return i == 1 ? 0 : i;
}

// What follows the O-word, without blanks at its beginning; `code` begins with one.
std::string_view behind_label(std::string_view code) {
    std::size_t i = line_number(code) + 1;
    while (i < code.size() && code[i] == ' ') ++i;
    const char open = i < code.size() ? code[i] : ' ';
    if (open == '<' || open == '[') {
        const std::size_t end = code.find(open == '<' ? '>' : ']', i);
        i = end == code.npos ? code.size() : end + 1;
    } else
        while (i < code.size() && is_digit(code[i])) ++i;
    while (i < code.size() && (code[i] == ' ' || code[i] == '\t')) ++i;
    return code.substr(i);
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = upper(c);
    return out;
}

} // namespace

bool is_label(std::string_view code) {
    std::size_t i = line_number(code);
    if (i >= code.size() || upper(code[i]) != 'O') return false;
    ++i;
    while (i < code.size() && code[i] == ' ') ++i;
    return i < code.size() && (is_digit(code[i]) || code[i] == '<' || code[i] == '[');
}

bool controls_flow(std::string_view code) {
    if (is_label(code)) return !behind_label(code).empty();
    const std::string word = upper(code.substr(0, code.find_first_of(" \t[")));
    return word == "WHILE" || word == "GOTO" || (word == "IF" && upper(code).find("GOTO") != std::string::npos);
}

bool OwnCommand::is(std::string_view name) const { return upper(code_.substr(0, code_.find_first_of(" \t"))) == name; }

std::string OwnCommand::value(std::string_view key) const {
    const std::string all = upper(code_), looked_for = std::string(key) + "=";
    for (std::size_t at = 0; (at = all.find(looked_for, at)) != std::string::npos; ++at) {
        if (at > 0 && all[at - 1] != ' ' && all[at - 1] != '\t') continue;
        std::string_view rest = code_.substr(at + looked_for.size());
        if (!rest.empty() && rest[0] == '"') {
            rest.remove_prefix(1);
            return std::string(rest.substr(0, rest.find('"')));
        }
        return std::string(rest.substr(0, rest.find_first_of(" \t")));
    }
    return "";
}

bool OwnCommand::shifts(std::string_view axis) const {
    const auto is_zero = [](const std::string& text) { return std::atof(text.c_str()) == 0; };
    return !is_zero(value(axis)) || !is_zero(value(std::string(axis) + "_ADJUST"));
}

void Condition::line(std::string_view text) {
    indent_ = std::min(text.find_first_not_of(" \t"), text.size());
    inside_ = open_ && indent_ > outer_;
    open_ = inside_;
}

void Condition::command(std::string_view code) {
    if (inside_) return; // the outer block goes on
    const std::string word = upper(code.substr(0, code.find_first_of(" \t{")));
    open_ = word == "IF" || word == "ELIF" || word == "ELSE";
    outer_ = indent_;
}

} // namespace filum::ingest
