// Text with macros, as slicers have them in their G-code: {expression}, [name], {if condition}...{endif}; see
// docs/slicer-profiles.md for the language.
#pragma once

#include "macro/syntax.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::macro {

// A template that has been read.
struct Template {
    std::string name{}; // what messages call it: start_gcode
    std::string text{};
    std::shared_ptr<const Block> block{};
};

// Throws Error(bad_input) naming the template, the line and the column of what is wrong.
Template parsed(const std::string& name, const std::string& text, Style style = Style::slicer);

// What the names in templates stand for, and what one template leaves for the next one.
struct Scope {
    std::function<const Variable*(std::string_view)> find; // null for an unknown name
    std::size_t extruder = 0;                              // the item of a list that [name] means
    NumberFormat numbers{};
    std::map<std::string, Variable, std::less<>> globals{};
    std::uint64_t random = 1;  // state of the generator
    bool numbers_hold = false; // 0 and 1 are conditions, too: of settings whose types are unknown
    // Names that a template may give a value, for those after it in the same template.
    std::vector<std::string> writable{"position", "e_position", "e_retracted", "e_restart_extra"};
};

// The text of a template.  Throws Error(bad_input) naming the template, the line and the column: for a name that
// scope.find does not know, a value of the wrong type, a division by zero, a text of more than 16 MB.
std::string expand(const Template& from, Scope& scope);

// The first fault of a template without its values: its syntax, or a name that is neither known nor defined in it.
std::optional<Fault> fault(std::string_view text, Style style, const std::function<bool(std::string_view)>& known);

} // namespace filum::macro
