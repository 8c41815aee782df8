// Expands text with macros, as in slicers' G-code: {expression}, [name], {if condition}...{endif}.
// docs/slicer-profiles.md describes the language.
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

// A parsed template.
struct Template {
    std::string name{}; // its name in messages, such as start_gcode
    std::string text{};
    std::shared_ptr<const Block> block{};
};

// Parses a template.  Throws Error(bad_input) with the template, the line and the column of a fault.
Template parsed(const std::string& name, const std::string& text, Style style = Style::slicer);

// The values of names in templates, and the state that one template leaves for the next one.
struct Scope {
    std::function<const Variable*(std::string_view)> find; // returns null for an unknown name
    std::size_t extruder = 0;                              // index of the list item that [name] stands for
    NumberFormat numbers{};
    std::map<std::string, Variable, std::less<>> globals{};
    std::uint64_t random = 1;  // state of the random generator
    bool numbers_hold = false; // 0 and 1 are conditions too, for settings of unknown type
    // Known names that a template may assign.  The new value holds for the rest of that template.
    std::vector<std::string> writable{"position", "e_position", "e_retracted", "e_restart_extra"};
};

// Expands a template to text. Throws Error(bad_input) with the template, the line and the column of the fault. Faults
// are a name that scope.find does not know, a value of the wrong type and a division by zero. Text of more than 16 MB
// is a fault, too.
std::string expand(const Template& from, Scope& scope);

// Finds the first fault of a template without evaluating it: bad syntax, or a name that is not known and not defined in
// it. None if there is no fault.
std::optional<Fault> fault(std::string_view text, Style style, const std::function<bool(std::string_view)>& known);

} // namespace filum::macro
