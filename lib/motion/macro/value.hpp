// Values of the macro language of slicers' G-code.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace filum::macro {

// A value.  std::monostate is the `nil` of settings that a filament leaves to its printer.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

// The name of a value's type in messages: "a whole number".
const char* type_name(const Value& value);

// The format of numbers in expanded text.
struct NumberFormat {
    int decimals = -1; // most decimals, without an exponent; -1: six significant digits, as C++ streams
};

// The text that an expression with this value expands to.
std::string text_of(const Value& value, const NumberFormat& format = {});

// A setting, or a variable of the template: one value, or a list.
struct Variable {
    bool list = false;
    std::vector<Value> items{}; // one, unless it is a list
    // The items as [name] writes them, where that differs from text_of: 15%, 0 for false.
    std::vector<std::string> written{};
    bool either = false; // a setting of unknown type: it may be used with or without an index

    static Variable one(Value value) { return {false, {std::move(value)}, {}, false}; }
    static Variable many(std::vector<Value> values) { return {true, std::move(values), {}, false}; }
};

} // namespace filum::macro
