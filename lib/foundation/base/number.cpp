#include "base/number.hpp"

#include "base/error.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

namespace filum {

namespace {

constexpr double kPow10[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

// Removes trailing zeros, and then a trailing point, from out[from..] if it has a point. "-0" becomes "0".
void trim_zeros(std::string& out, std::size_t from) {
    if (out.find('.', from) == std::string::npos) return;
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
    if (out.size() == from + 2 && out[from] == '-' && out[from + 1] == '0') out.erase(from, 1);
}

} // namespace

void append_fixed(std::string& out, double value, int decimals) {
    const double scaled = std::abs(value) * kPow10[decimals];
    if (scaled < 9e15) { // fits exactly into 64 bits: four times faster than to_chars
        auto units = static_cast<std::uint64_t>(std::nearbyint(scaled));
        if (value < 0 && units != 0) out.push_back('-');
        int digits = decimals;
        while (digits > 0 && units % 10 == 0) {
            units /= 10;
            --digits;
        }
        char buffer[24];
        char* end = buffer + sizeof buffer;
        char* at = end;
        for (int k = 0; k < digits; ++k, units /= 10) *--at = static_cast<char>('0' + units % 10);
        if (digits > 0) *--at = '.';
        do {
            *--at = static_cast<char>('0' + units % 10);
            units /= 10;
        } while (units != 0);
        out.append(at, static_cast<std::size_t>(end - at));
        return;
    }
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals).ptr;
    const std::size_t from = out.size();
    out.append(buffer, end);
    trim_zeros(out, from);
}

std::string fixed_text(double value, int decimals) {
    std::string out;
    append_fixed(out, value, decimals);
    return out;
}

std::string shortest_text(double value) {
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr;
    return {buffer, end};
}

namespace {

std::optional<double> number_in(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

// What to write for a number with a decimal comma: "; write 0.2". "" for other text.
std::string with_point(std::string text) {
    const auto comma = text.find(',');
    if (comma == std::string::npos) return "";
    text[comma] = '.';
    return number_in(text) ? "; write " + text : "";
}

} // namespace

double parse_number(std::string_view text, std::string_view what) {
    const auto value = number_in(text);
    if (!value)
        throw Error(Exit::usage, "cannot read '" + std::string(text) + "' as a number for " + std::string(what) +
                                     with_point(std::string(text)));
    return *value;
}

std::vector<std::pair<std::string, double>> parse_weights(std::string_view words, const std::string& what) {
    std::vector<std::pair<std::string, double>> out;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(','), words.size());
        const std::string word(words.substr(0, end));
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw Error(Exit::usage, "cannot use " + what + " '" + word + "'; say NAME=NUMBER");
        const double weight = parse_number(std::string_view(word).substr(equals + 1), what);
        if (!std::isfinite(weight) || weight < 0)
            throw Error(Exit::usage, "cannot use " + what + " '" + word + "'; weights are 0 or more");
        out.emplace_back(word.substr(0, equals), weight);
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return out;
}

} // namespace filum
