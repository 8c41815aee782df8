// Values of the macro language of slicers' G-code.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace filum::macro {

// Nothing is the `nil` of settings that a filament leaves to its printer.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

// What messages call the type of a value: "a whole number".
const char* type_name(const Value& value);

// How numbers of expressions are written.
struct NumberFormat {
    int decimals = -1; // up to so many and never an exponent; -1: six significant digits, as C++ streams write them
};

// The text that an expression of this value leaves in the program.
std::string text_of(const Value& value, const NumberFormat& format = {});

// A setting, or a variable of the template: one value, or a list.
struct Variable {
    bool list = false;
    std::vector<Value> items{}; // one, unless it is a list
    // The same as [name] writes them, where that differs from text_of: 15%, 0 for false.
    std::vector<std::string> written{};
    bool either = false; // of a setting of unknown type: with an index or without, both are right

    static Variable one(Value value) { return {false, {std::move(value)}, {}, false}; }
    static Variable many(std::vector<Value> values) { return {true, std::move(values), {}, false}; }
};

} // namespace filum::macro
