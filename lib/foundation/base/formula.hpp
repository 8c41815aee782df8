// A number as a formula of variables, such as "0.3 + 0.02 * x".
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace filum {

// Numbers, the given variables and pi; + - * / ^, brackets; sqrt, abs, exp, sin, cos (of rad), min(a, b), max(a, b).
class Formula {
  public:
    Formula() = default;
    // Parses `text`; `variables` are the names that it may use. Throws Error(usage) with the place of the first fault.
    // `what`: the option, for the message.
    Formula(const std::string& text, const std::vector<std::string>& variables, const std::string& what);

    [[nodiscard]] bool given() const { return !steps_.empty(); }
    [[nodiscard]] const std::string& text() const { return text_; }
    // Whether the value may depend on a variable, by its number.
    [[nodiscard]] bool uses(std::size_t variable) const;
    // The value; infinite or not a number where the formula has none. Requires given().
    [[nodiscard]] double operator()(std::span<const double> variables) const;

    // The steps of the evaluation, which work on a stack of numbers.
    enum class What : std::uint8_t {
        number,
        variable,
        negate,
        add,
        subtract,
        multiply,
        divide,
        power,
        sqrt,
        abs,
        exp,
        sin,
        cos,
        min,
        max
    };
    struct Step {
        What what = What::number;
        double number = 0;
        std::size_t variable = 0;
    };

  private:
    std::string text_;
    std::vector<Step> steps_;
};

} // namespace filum
