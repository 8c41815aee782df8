// Named numbers, and how they are written: as an aligned table, as TSV, as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace filum::figures {

// One line.  Numbers keep a fixed count of decimals; a value that is not finite is written as "-" (JSON: null).
struct Figure {
    std::string group; // "coverage"; consecutive figures of a group stand together
    std::string name;  // "worst layer"
    std::variant<std::uint64_t, double, std::string> value;
    int decimals = 3;
    std::string unit = {}; // "mm", "mm2", "s"; empty for counts and shares
    std::string key = {};  // for programs: meanings.hpp
};

using Figures = std::vector<Figure>;

enum class Format { table, tsv, json };
Format format_named(std::string_view name); // table for any other name

// Of all reports of figures: goes up when a key goes away or changes its meaning.
constexpr int kReportVersion = 1;

// table: groups under headings, values aligned.  tsv: a head line, then key, value, unit.  json: {"key": value},
// numbers as numbers.  Those two begin with the name of the report and its version.  A figure without a key gets its
// name and unit.
std::string text(const Figures& figures, Format format, std::string_view report = "metrics");

} // namespace filum::figures
