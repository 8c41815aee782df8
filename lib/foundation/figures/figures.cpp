#include "figures/figures.hpp"

#include "base/json.hpp"
#include "base/printable.hpp"

#include "base/number.hpp"
#include "figures/meanings.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace filum::figures {

namespace {

// With exactly `decimals` digits: columns of numbers line up, and diffs stay small.
std::string fixed(double v, int decimals) {
    if (!std::isfinite(v)) return "-";
    if (v == 0) v = 0; // no minus zero
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::fixed, decimals).ptr;
    std::string out(buffer, end);
    if (out.find_first_not_of("-0.") == std::string::npos && out.front() == '-') out.erase(0, 1);
    return out;
}

std::string value(const Figure& f) {
    if (const auto* n = std::get_if<std::uint64_t>(&f.value)) return std::to_string(*n);
    if (const auto* d = std::get_if<double>(&f.value)) return fixed(*d, f.decimals);
    return std::get<std::string>(f.value);
}

std::string key(const Figure& f) {
    return !f.key.empty() ? f.key : key_text(f.name + (f.unit.empty() ? "" : "_" + f.unit));
}

std::string table(const Figures& figures) {
    std::size_t left = 0, right = 0;
    for (const Figure& f : figures) {
        left = std::max(left, f.name.size());
        if (!std::holds_alternative<std::string>(f.value)) right = std::max(right, value(f).size());
    }
    std::string out;
    const std::string* group = nullptr;
    for (const Figure& f : figures) {
        if (group == nullptr || *group != f.group) out += (group == nullptr ? "" : "\n") + f.group + "\n";
        group = &f.group;
        const std::string v = value(f);
        const bool number = !std::holds_alternative<std::string>(f.value);
        out += "  " + f.name + std::string(left - f.name.size() + 2, ' ');
        if (number) out += std::string(right - v.size(), ' ');
        out += printable(v) + (f.unit.empty() ? "" : " " + f.unit) + "\n";
    }
    return out;
}

std::string tsv(const Figures& figures, std::string_view report) {
    std::string out =
        "key\tvalue\tunit\nreport\t" + std::string(report) + "\t\nversion\t" + std::to_string(kReportVersion) + "\t\n";
    for (const Figure& f : figures) out += printable(key(f)) + "\t" + printable(value(f)) + "\t" + f.unit + "\n";
    return out;
}

std::string json(const Figures& figures, std::string_view report) {
    std::string out =
        "{\n  \"report\": " + json_text(std::string(report)) + ",\n  \"version\": " + std::to_string(kReportVersion);
    for (const Figure& f : figures) {
        std::string v = value(f);
        if (std::holds_alternative<std::string>(f.value))
            v = json_text(v);
        else if (v == "-")
            v = "null";
        out += ",\n  " + json_text(key(f)) + ": " + v;
    }
    return out + "\n}\n";
}

} // namespace

Format format_named(std::string_view name) {
    return name == "tsv" ? Format::tsv : name == "json" ? Format::json : Format::table;
}

std::string text(const Figures& figures, Format format, std::string_view report) {
    switch (format) {
    case Format::table:
        return table(figures);
    case Format::tsv:
        return tsv(figures, report);
    case Format::json:
        return json(figures, report);
    }
    return {};
}

} // namespace filum::figures
