// A command's self-description as text: help, man page, Markdown, shell completion.
#pragma once

#include "cli/spec.hpp"

#include <string>

namespace filum::cli {

std::string version(); // the version of the project: "0.1.0"
// " (commit 1a2b3c4)", the commit that the program was built from; "" if the build did not know it. Not part of the
// history.
std::string commit();

std::string help(const Spec& spec);
std::string man_page(const Spec& spec); // roff, section 1
std::string markdown(const Spec& spec); // docs/commands/NAME.md
// One line for shell completion: the name, then the options as --flag, --option=UNIT, --file=FILE, --choice={a,b}.
std::string completion_line(const Spec& spec);

// The facts that the tests and the front command rely on, one a line:
// "synopsis ...", "in file|text|none|stream Regions", "out ...", "flag NAME", "option NAME UNIT", "default NAME VALUE",
// "range NAME LEAST MOST [open] [zero]", "limit NAME", "needs NAME NEED", "example COMMAND".
// NEED has the syntax of Option::when.
std::string contract(const Spec& spec);

// The value of an option as the history records it.
std::string value_text(const Option& option);

} // namespace filum::cli
