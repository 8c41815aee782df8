#include "plate/grid.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace filum::plate {

namespace {

constexpr std::size_t kMost = 1000; // most columns, and most rows
constexpr std::size_t kLetters = 26;

std::string row_name(std::size_t row) {
    std::string out(1, static_cast<char>('A' + row % kLetters));
    return row < kLetters ? out : row_name(row / kLetters - 1) + out;
}

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::size_t count(const std::string& text, const std::string& grid) {
    const bool digits = !text.empty() && text.size() <= 4 &&
                        std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    const std::size_t out = digits ? std::stoul(text) : 0;
    if (out == 0 || out > kMost)
        throw Error(Exit::usage, "cannot use '" + grid + "' for --grid: it takes columns x rows, as 4x3, of 1 to " +
                                     std::to_string(kMost) + " each");
    return out;
}

} // namespace

Grid well_plate(std::int64_t wells) {
    switch (wells) {
    case 6:
        return {3, 2, {39.12, 39.12}, 17.4};
    case 12:
        return {4, 3, {26.01, 26.01}, 17.53};
    case 24:
        return {6, 4, {19.3, 19.3}, 17.4, {1.85, 0}};
    case 48:
        return {8, 6, {13.08, 13.08}, 17.4};
    case 96:
        return {12, 8, {9, 9}, 10.67};
    default:
        throw Error(Exit::usage, "cannot use '" + std::to_string(wells) +
                                     "' for --wells: it must be 6, 12, 24, 48 or 96; give --grid and --pitch for "
                                     "others");
    }
}

Grid parse_grid(const std::string& text, const std::vector<double>& pitch) {
    const std::size_t cross = std::min(text.find_first_of("xX"), text.size());
    Grid out;
    out.columns = count(text.substr(0, cross), text);
    out.rows = count(text.substr(std::min(cross + 1, text.size())), text);
    if (pitch.size() != 1 && pitch.size() != 2)
        throw Error(Exit::usage, "cannot use --grid without the distance of its places: give --pitch, one number or "
                                 "two, as --pitch 26");
    out.pitch = {pitch.front(), pitch.back()};
    return out;
}

std::string well_name(const Grid& grid, std::size_t index) {
    return row_name(index / grid.columns) + std::to_string(index % grid.columns + 1);
}

std::vector<std::size_t> wells_named(const Grid& grid, const std::string& names) {
    std::vector<char> wanted(grid.size(), names.empty() ? 1 : 0);
    for (std::size_t from = 0; from < names.size();) {
        const std::size_t comma = std::min(names.find(',', from), names.size());
        const std::string name = upper(names.substr(from, comma - from));
        from = comma + 1;
        std::size_t k = 0;
        while (k < grid.size() && well_name(grid, k) != name) ++k;
        if (k == grid.size())
            throw Error(Exit::usage, "cannot use '" + name + "' for --in-wells: wells are A1 to " +
                                         well_name(grid, grid.size() - 1));
        wanted[k] = 1;
    }
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k] != 0) out.push_back(k);
    return out;
}

Vec2 middle(const Grid& grid, std::size_t index) {
    const std::size_t rows_before = index / grid.columns;
    const auto column = static_cast<double>(index % grid.columns), row = static_cast<double>(rows_before);
    return grid.shift + Vec2{(column - static_cast<double>(grid.columns - 1) / 2) * grid.pitch.x,
                             (static_cast<double>(grid.rows - 1) / 2 - row) * grid.pitch.y};
}

} // namespace filum::plate
