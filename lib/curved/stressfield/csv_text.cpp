#include "stressfield/csv_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace filum::stressfield {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view t, std::string_view of) {
    const auto from = t.find_first_not_of(of);
    return from == t.npos ? std::string_view() : t.substr(from, t.find_last_not_of(of) + 1 - from);
}

std::string_view without_quotes(std::string_view t) {
    t = trimmed(t, " \t\r");
    return t.size() > 1 && t.front() == '"' && t.back() == '"' ? trimmed(t.substr(1, t.size() - 2), " \t")
                                                               : trimmed(t, " \t\r\"");
}

// Digits and marks of a number, without sign and exponent.
std::string_view mantissa(std::string_view cell) {
    if (!cell.empty() && (cell.front() == '-' || cell.front() == '+')) cell.remove_prefix(1);
    return cell.substr(0, cell.find_first_not_of("0123456789.,"));
}

// Whether `mark` divides the digits before the decimal mark into groups of three.
bool grouped(std::string_view whole, char mark) {
    std::size_t at = whole.find(mark);
    if (at == 0 || at > 3 || at == whole.npos || whole.front() == '0') return false;
    for (; at < whole.size(); at += 4)
        if (whole[at] != mark || at + 4 > whole.size() ||
            !std::all_of(whole.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                         whole.begin() + static_cast<std::ptrdiff_t>(at) + 4, is_digit))
            return false;
    return true;
}

} // namespace

char separator(std::string_view line) {
    bool seen[3] = {};
    constexpr std::string_view marks = ";\t,";
    bool quoted = false;
    for (const char c : line) {
        quoted ^= c == '"';
        if (const auto at = marks.find(c); !quoted && at != marks.npos) seen[at] = true;
    }
    for (std::size_t k = 0; k < 3; ++k)
        if (seen[k]) return marks[k];
    return ' ';
}

void split(std::string_view line, char mark, Cells& out) {
    out.clear();
    bool quoted = false;
    std::size_t from = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        const bool end = i == line.size();
        if (!end && line[i] == '"') quoted = !quoted;
        const bool between = !end && !quoted && (line[i] == mark || (mark == ' ' && line[i] == '\t'));
        if (!end && !between) continue;
        const auto cell = without_quotes(line.substr(from, i - from));
        if (!cell.empty() || (mark != ' ' && !end)) out.push_back(cell);
        from = i + 1;
    }
}

void split_wide(std::string_view line, Cells& out) {
    out.clear();
    for (std::size_t from = 0; from < line.size();) {
        std::size_t end = std::min({line.find("  ", from), line.find('\t', from), line.size()});
        const auto cell = without_quotes(line.substr(from, end - from));
        if (!cell.empty()) out.push_back(cell);
        from = std::min(line.find_first_not_of(" \t", end), line.size());
    }
}

bool TextLines::next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    ++number_;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    ended_ = end < text_.size();
    line = trimmed(text_.substr(at_, end - at_), " ");
    at_ = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
    return true;
}

void DecimalEvidence::add(std::string_view cell) {
    const std::string_view digits = mantissa(cell);
    if (digits.empty() || !std::any_of(digits.begin(), digits.end(), is_digit)) return;
    const auto commas = std::count(digits.begin(), digits.end(), ','),
               points = std::count(digits.begin(), digits.end(), '.');
    if (commas + points == 0) return;
    if (commas > 0 && points > 0) {
        (digits.rfind(',') > digits.rfind('.') ? comma_ : point_) = true;
        return;
    }
    const char mark = commas > 0 ? ',' : '.';
    const bool may_group = grouped(digits, mark) && digits.size() == cell.substr(cell.find(digits)).size();
    if (commas + points > 1) { // groups, or not a number
        if (may_group) (mark == ',' ? point_ : comma_) = true;
        return;
    }
    if (!may_group)
        (mark == ',' ? comma_ : point_) = true;
    else if (mark == ',' && doubtful_.empty())
        doubtful_ = cell;
}

std::optional<double> cell_value(std::string_view cell, Decimal decimal) {
    double value = std::nan("");
    if (cell.empty()) return value;
    if (cell.front() == '+') cell.remove_prefix(1);
    std::string text;
    const std::string_view digits = mantissa(cell);
    const char mark = decimal == Decimal::comma ? ',' : '.', group = decimal == Decimal::comma ? '.' : ',';
    const std::string_view whole = digits.substr(0, digits.find(mark));
    const bool groups = whole.find(group) != whole.npos;
    if (groups && !grouped(whole, group)) return {};
    if (groups || decimal == Decimal::comma || cell.find_first_of("dD") != cell.npos) {
        const auto end_of_digits = static_cast<std::size_t>(digits.data() - cell.data()) + digits.size();
        for (std::size_t i = 0; i < cell.size(); ++i) {
            const bool in_digits = i < end_of_digits;
            if (in_digits && cell[i] == group) continue;
            const bool exponent = i == end_of_digits && i > 0 && (cell[i] == 'd' || cell[i] == 'D'); // FORTRAN's
            text += in_digits && cell[i] == mark ? '.' : exponent ? 'e' : cell[i];
        }
        cell = text;
    }
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    if (error == std::errc::invalid_argument || stop != end) return {};
    if (error == std::errc::result_out_of_range) return std::nan("");
    return value;
}

} // namespace filum::stressfield
