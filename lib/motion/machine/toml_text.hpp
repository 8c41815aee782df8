// Reads a TOML text into values of our own, so that no other file depends on the TOML library or its version.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace filum::machine {

// A value of a TOML text. Tables are sorted by key, so that nothing depends on a hash.
struct TomlValue {
    using List = std::vector<TomlValue>;
    using Table = std::map<std::string, TomlValue>;

    std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table>
        value;             // monostate: a date or time
    std::string file = {}; // that the value was read from; "" if none
    std::size_t line = 0; // on which it begins, from 1; 0 if it was not read from a file. A text of several lines whose
                          // first line is empty begins on the line after its quotes

    [[nodiscard]] bool is_table() const { return std::holds_alternative<Table>(value); }
    [[nodiscard]] bool is_list() const { return std::holds_alternative<List>(value); }
    [[nodiscard]] bool is_text() const { return std::holds_alternative<std::string>(value); }
    // Preconditions: the value is of this type.
    [[nodiscard]] Table& table() { return std::get<Table>(value); }
    [[nodiscard]] const Table& table() const { return std::get<Table>(value); }
    [[nodiscard]] const List& list() const { return std::get<List>(value); }
    [[nodiscard]] const std::string& text() const { return std::get<std::string>(value); }
};

// The values of a TOML text. `file` is the name of its file for messages and for TomlValue::file.
// Throws Error(bad_input), beginning with `failed`, for a text that is no TOML, that has values nested deeper than 100
// brackets, or a byte that is not UTF-8.
TomlValue::Table read_toml(std::string_view text, const std::string& file, const std::string& failed);

} // namespace filum::machine
