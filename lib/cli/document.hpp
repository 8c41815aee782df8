// A command's self-description as text: help, man page, Markdown, shell completion.
#pragma once

#include "cli/spec.hpp"

#include <string>

namespace filum::cli {

std::string version(); // of the project: "0.1.0"
std::string commit();  // that it was built from, " (commit 1a2b3c4)"; "" where nobody knows. Not in the history

std::string help(const Spec& spec);
std::string man_page(const Spec& spec); // roff, section 1
std::string markdown(const Spec& spec); // docs/commands/NAME.md
// One line: the name, then the options: --flag, --option=UNIT, --file=FILE, --choice={a,b}.
std::string completion_line(const Spec& spec);

// One line per fact that the tests and the front command go by: "synopsis ...", "in file|text|none|stream Regions",
// "out ...", "flag NAME", "option NAME UNIT", "default NAME VALUE", "range NAME LEAST MOST [open] [zero]", "limit
// NAME", "needs NAME" and a need as needs.hpp writes it, "example COMMAND".
std::string contract(const Spec& spec);

// The value of an option as it stands in the history.
std::string value_text(const Option& option);

} // namespace filum::cli
