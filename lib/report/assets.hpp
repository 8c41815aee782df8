// The parts of the page that are the same for all, put into the program when it is built: those of page/, and three.js.
#pragma once

#include <string_view>

namespace filum::report {

// Throws Error(failure) for a name that there is none of.
std::string_view asset(std::string_view name);

} // namespace filum::report
