#include "stressfield/frd_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace filum::stressfield {

namespace {

constexpr std::size_t kWidth = 12;
constexpr std::size_t kMantissa = 8; // sign, digit, point, five digits

bool digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_blanks(std::string_view t) {
    while (!t.empty() && t.front() == ' ') t.remove_prefix(1);
    while (!t.empty() && t.back() == ' ') t.remove_suffix(1);
    return t;
}

// The usual form " d.dddddE+dd", for which one product or quotient of exact numbers gives the nearest value.
bool usual(const char* f, double& value) {
    static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                       1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                       1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    if ((f[0] != ' ' && f[0] != '-') || f[2] != '.' || f[8] != 'E' || (f[9] != '+' && f[9] != '-')) return false;
    for (const int k : {1, 3, 4, 5, 6, 7, 10, 11})
        if (!digit(f[k])) return false;
    int mantissa = f[1] - '0';
    for (int k = 3; k < 8; ++k) mantissa = 10 * mantissa + (f[k] - '0');
    int exponent = 10 * (f[10] - '0') + (f[11] - '0');
    if (f[9] == '-') exponent = -exponent;
    exponent -= 5;
    if (exponent < -22 || exponent > 22) return false;
    value = exponent < 0 ? mantissa / kPowers[static_cast<std::size_t>(-exponent)]
                         : mantissa * kPowers[static_cast<std::size_t>(exponent)];
    if (f[0] == '-') value = -value;
    return true;
}

// Removes a number of the described form from the front of `text`.
bool take(std::string_view& text, double& value) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    std::size_t at = text.starts_with('-') ? 1 : 0;
    const std::size_t exponent = at + kMantissa - 1;
    if (text.size() < exponent + 3 || text[at + 1] != '.') return number(std::exchange(text, {}), value);
    at = exponent + (text[exponent] == 'E' ? 1 : 0);
    if (text[at] == '+' || text[at] == '-') ++at;
    while (at < text.size() && digit(text[at])) ++at;
    if (at < text.size() && text[at] == '.') --at; // the digit belongs to the next number
    const std::string_view own = text.substr(0, at);
    text.remove_prefix(at);
    return number(own, value);
}

} // namespace

bool whole(std::string_view field, long long& value) {
    field = without_blanks(field);
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    return error == std::errc() && stop == field.data() + field.size();
}

bool number(std::string_view field, double& value) {
    field = without_blanks(field);
    if (field.starts_with('+')) field.remove_prefix(1);
    std::string with;
    const std::size_t sign = field.find_last_of("+-");
    if (sign != std::string_view::npos && sign > 0 && digit(field[sign - 1])) {
        with = std::string(field.substr(0, sign)) + "E" + std::string(field.substr(sign));
        field = with;
    }
    const auto [stop, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error == std::errc::result_out_of_range)
        value = field.find("E-") != std::string_view::npos ? 0 : std::nan(""); // underflow gives 0, overflow nan
    else if (error != std::errc())
        return false;
    return stop == field.data() + field.size();
}

bool numbers(std::string_view line, std::size_t from, std::size_t count, double* values) {
    if (line.size() > from + kWidth * count) {
        line.remove_prefix(from);
        for (std::size_t k = 0; k < count; ++k)
            if (!take(line, values[k])) return false;
        return without_blanks(line).empty();
    }
    if (line.size() < from + kWidth * count) return false;
    for (std::size_t k = 0; k < count; ++k) {
        const char* const field = line.data() + from + kWidth * k;
        if (!usual(field, values[k]) && !number({field, kWidth}, values[k])) return false;
    }
    return true;
}

bool Lines::seek(std::string_view word) {
    const std::string mark = "\n" + std::string(word);
    if (text_.substr(at_).starts_with(word)) return true;
    const std::size_t found = text_.find(mark, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + 1;
    return found != std::string_view::npos;
}

std::size_t Lines::line() const {
    return 1 + static_cast<std::size_t>(
                   std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(last_), '\n'));
}

} // namespace filum::stressfield
