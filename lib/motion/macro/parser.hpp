// Parses templates of G-code into trees.
#pragma once

#include "macro/syntax.hpp"

#include <string>
#include <string_view>

namespace filum::macro {

// A fault, thrown to the caller that knows the name of the template.
struct FaultAt {
    std::string why{};
    std::size_t at = 0; // offset in the template, bytes
};

// Parses a template.  Throws FaultAt.
Block parse(std::string_view text, Style style);

// Adds the line and column of a fault.
Fault placed(const FaultAt& fault, std::string_view text);

} // namespace filum::macro
