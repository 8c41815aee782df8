// Regular expressions that a hostile pattern cannot slow down: matched in time proportional to pattern times text.
#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::macro {

// A pattern with: characters, '.', [classes], \d \w \s \D \W \S \b \B, ^ $, groups, |, * + ? {n,m}.  A dot stands for
// any character, line ends, too.
class Regex {
  public:
    // Throws std::invalid_argument with what is wrong: a bracket without its partner, a look-around or a
    // back-reference, which it does not know, or a pattern that repeats to more than 20,000 steps.
    explicit Regex(std::string_view pattern);

    // Whether the pattern matches the whole text.
    [[nodiscard]] bool matches(std::string_view text) const;

    enum class Op : std::uint8_t { set, split, jump, begin, end, boundary, no_boundary, done };
    struct Step {
        Op op = Op::done;
        std::size_t a = 0, b = 0; // where to go on; of a set, its number
    };

  private:
    friend class RegexCompiler;
    std::vector<Step> steps_;
    std::vector<std::bitset<256>> sets_;
};

} // namespace filum::macro
