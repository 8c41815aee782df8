// Text of a profile with {placeholders}; "{{" and "}}" stand for single braces.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

using Values = std::map<std::string, double>;

// Names that every program knows, besides the profile's own values.
const std::vector<std::string>& known_placeholders();

// What is wrong with `text`: an unknown name (neither known nor in `own`), a brace without its partner; "" if nothing.
// `line` is where, counted from 0.
struct TemplateFault {
    std::string why;
    std::size_t line = 0;
};
TemplateFault check_template(std::string_view text, const Values& own);

// `text` with each {name} replaced by its number (up to so many decimals, never an exponent).
// Throws Error(bad_input) for an unknown name or a stray brace.
std::string expand(std::string_view text, const Values& values, int decimals = 5);

} // namespace filum::machine
