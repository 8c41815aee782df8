// Reads templates of G-code into trees.
#pragma once

#include "macro/syntax.hpp"

#include <string>
#include <string_view>

namespace filum::macro {

// A fault on its way to whoever knows what the template is called.
struct FaultAt {
    std::string why{};
    std::size_t at = 0; // bytes
};

// Throws FaultAt.
Block parse(std::string_view text, Style style);

// The line and column of a place.
Fault placed(const FaultAt& fault, std::string_view text);

} // namespace filum::macro
