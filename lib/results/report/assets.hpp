// The parts that are the same in all report pages: the files of page/, and three.js. The build embeds them in the
// program.
#pragma once

#include <string_view>

namespace filum::report {

// The contents of the file with that name. Throws Error(failure) for an unknown name.
std::string_view asset(std::string_view name);

} // namespace filum::report
