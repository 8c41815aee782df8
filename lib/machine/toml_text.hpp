// What has to be known of a TOML text before its parser sees it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

struct TomlText {
    std::string fault;       // "" or what is wrong with it
    std::size_t line = 0;    // of the fault, counted from 1
    std::vector<bool> opens; // by line: it ends by opening a text of several lines, whose first line is the next one
};

// toml++ 3.3 is undefined on a section without a name ("[=") and on letters beyond ASCII in keys, so both are found
// here; in texts in quotes and in comments any UTF-8 is left to it.  Control characters are faults everywhere.
TomlText examine(std::string_view text);

} // namespace filum::machine
