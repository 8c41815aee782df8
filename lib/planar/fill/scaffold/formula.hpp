// A number as a formula of variables, such as "0.3 + 0.02 * x".
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace filum::fill::scaffold {

// What muParser reads: numbers, the given variables and pi; + - * / ^, comparisons, a ? b : c, brackets; sqrt, abs,
// exp, sin, cos (of rad), min, max and its other functions. 2^3^2 is 2^(3^2), and -2^2 is -4.
class Formula {
  public:
    Formula() = default;
    // Parses `text`; `variables` are the names that it may use. Throws Error(usage) with the place of the first fault.
    // `what`: the option, for the message.
    Formula(const std::string& text, const std::vector<std::string>& variables, const std::string& what);

    [[nodiscard]] bool given() const { return parsed_ != nullptr; }
    [[nodiscard]] const std::string& text() const { return text_; }
    // Whether the value may depend on a variable, by its number.
    [[nodiscard]] bool uses(std::size_t variable) const;
    // The value; infinite or not a number where the formula has none. Requires given(). May be called by several
    // threads, which take turns.
    [[nodiscard]] double operator()(std::span<const double> variables) const;

  private:
    struct Parsed;
    std::string text_;
    std::shared_ptr<Parsed> parsed_;
};

} // namespace filum::fill::scaffold
