#include "macro/value.hpp"

#include "base/number.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace filum::macro {

const char* type_name(const Value& value) {
    constexpr std::array kNames{"nil", "true or false", "a whole number", "a number", "a text"};
    return kNames[value.index()];
}

std::string text_of(const Value& value, const NumberFormat& format) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr) return "";
    std::string out;
    if (format.decimals >= 0) {
        append_fixed(out, *number, format.decimals);
        return out;
    }
    std::array<char, 64> digits{};
    constexpr int significant = 6; // as std::ostream
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), *number, std::chars_format::general, significant);
    return {digits.data(), end.ptr};
}

} // namespace filum::macro
