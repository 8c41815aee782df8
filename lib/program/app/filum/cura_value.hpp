// Values of Cura's formulas, and Python's operations on them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace filum::app::filum {

// Why a value cannot be calculated, as a clause: "no file has 'key'".
struct MissingValue {
    std::string why{};
};

// A value of a formula.  Lists hold one value for each extruder, or what a formula lists.
struct CuraValue {
    using List = std::vector<CuraValue>;
    std::variant<MissingValue, bool, double, std::string, List> as{};

    [[nodiscard]] bool known() const { return !std::holds_alternative<MissingValue>(as); }
    [[nodiscard]] std::optional<double> number() const; // true and false are 1 and 0; none for all but numbers
    [[nodiscard]] bool truth() const;                   // whether Python takes the value as true
};

// Characters of a text, and the sum over all items of a list, also of lists in lists; 1 for everything else.
std::size_t size_of(const CuraValue& value);
// The largest size of a value. Formulas that double a text or a list, one on top of the other, would fill the memory.
inline constexpr std::size_t kLargestValue = 10'000;

// The value as settings of a file have it: "0.4", "1" and "0" for true and false, a text without quotes, "[0, 90]".
// Numbers have at most nine decimals.  Precondition: the value is known.
std::string text_of(const CuraValue& value);

// The value that the text of a setting stands for: a number if the whole text is one, else a text.
CuraValue value_of(std::string_view text);

// The value of `a` and `b` with a sign + - * / // % ** between them.  MissingValue: one of them is, it is no number or
// text, the sign divides by zero, the result is beyond all bounds or larger than kLargestValue.
CuraValue arithmetic(std::string_view sign, const CuraValue& a, const CuraValue& b);
// True or false for a sign == != < > <= >= in, or "not in".
CuraValue compared(std::string_view sign, const CuraValue& a, const CuraValue& b);
// The value of one of Python's functions, such as "round" or "math.ceil".  MissingValue: an argument is, or it is no
// number, or Filum does not know the function.
CuraValue python_function(const std::string& name, const CuraValue::List& arguments);

} // namespace filum::app::filum
