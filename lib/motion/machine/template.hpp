// Templates: text of a profile with {placeholders} in the macro language of docs/slicer-profiles.md.  "{{" and "}}"
// stand for single braces.  Brackets are plain text.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

using Values = std::map<std::string, double>;

// The names that every template may use, besides the profile's own values.
const std::vector<std::string>& known_placeholders();

// The first fault of a template: its syntax, or an unknown name that is not in `own`.  `why` is "" if there is
// none.  `line` is counted from 0.
struct TemplateFault {
    std::string why;
    std::size_t line = 0;
};
TemplateFault check_template(std::string_view text, const Values& own);

// The words in the braces of a text: names, and words of the macro language.
std::set<std::string> words_in_braces(std::string_view text);

// `text` with each {expression} replaced by its value.  Numbers have at most `decimals` decimals, and no exponent.
// Throws Error(bad_input) for an unknown name, wrong syntax, or a value that cannot be computed.
std::string expand(std::string_view text, const Values& values, int decimals = 5);

} // namespace filum::machine
