// Text of a profile with {placeholders} in the macro language of docs/slicer-profiles.md; "{{" and "}}" stand for
// single braces, and brackets for themselves.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

using Values = std::map<std::string, double>;

// Names that every program knows, besides the profile's own values.
const std::vector<std::string>& known_placeholders();

// What is wrong with `text`: its syntax, or a name that is neither known nor in `own`; "" if nothing.
// `line` is where, counted from 0.
struct TemplateFault {
    std::string why;
    std::size_t line = 0;
};
TemplateFault check_template(std::string_view text, const Values& own);

// The words in the braces of a text: names, and those of the language.
std::set<std::string> words_in_braces(std::string_view text);

// `text` with each {expression} replaced by its value; numbers have up to so many decimals, never an exponent.
// Throws Error(bad_input) for an unknown name, wrong syntax, or a value that cannot be computed.
std::string expand(std::string_view text, const Values& values, int decimals = 5);

} // namespace filum::machine
