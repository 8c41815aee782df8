// Regular expressions with bounded cost: RE2, which takes time proportional to the length of the text.
#pragma once

#include <memory>
#include <string_view>

namespace re2 {
class RE2;
}

namespace filum::macro {

// A pattern in Perl's syntax, as RE2 has it: without look-arounds and back-references. A dot matches any character,
// including line ends. Bytes are characters.
class Regex {
  public:
    // Throws std::invalid_argument with the fault, such as a bracket without its partner, a look-around, or a pattern
    // that repeats more than 1,000 times.
    explicit Regex(std::string_view pattern);

    // True if the pattern matches the whole text.
    [[nodiscard]] bool matches(std::string_view text) const;

  private:
    std::shared_ptr<const re2::RE2> pattern_;
};

} // namespace filum::macro
