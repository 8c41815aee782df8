// Checks of a TOML text before its parser reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace filum::machine {

struct TomlText {
    std::string fault;       // what is wrong with the text; "": nothing
    std::size_t line = 0;    // of the fault, counted from 1
    std::vector<bool> opens; // by line: a text of several lines opens at its end, and begins on the next line
};

// Finds the texts on which the behaviour of toml++ 3.3 is undefined: a section without a name ("[="), and letters
// beyond ASCII in keys.  UTF-8 in quoted texts and comments is left to toml++.  Control characters are faults
// everywhere.
TomlText examine(std::string_view text);

} // namespace filum::machine
