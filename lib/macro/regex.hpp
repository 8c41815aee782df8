// Regular expressions with bounded cost.  Matching takes time proportional to pattern length times text length.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::macro {

// A pattern. It may hold characters, '.', [classes], \d \w \s \D \W \S \b \B, ^ $, groups, |, * + ? {n,m}. A dot
// matches any character, including line ends.
class Regex {
  public:
    // Throws std::invalid_argument with the fault: a bracket without its partner, or a look-around or back-reference,
    // which are not supported. A pattern that repeats to more than 20,000 steps is a fault, too.
    explicit Regex(std::string_view pattern);

    // True if the pattern matches the whole text.
    [[nodiscard]] bool matches(std::string_view text) const;

    enum class Op : std::uint8_t { set, split, jump, begin, end, boundary, no_boundary, done };
    struct Step {
        Op op = Op::done;
        std::size_t a = 0, b = 0; // next steps; of a set, a is its number
    };

  private:
    friend class RegexCompiler;
    std::vector<Step> steps_;
    std::vector<std::bitset<256>> sets_;
};

} // namespace filum::macro
