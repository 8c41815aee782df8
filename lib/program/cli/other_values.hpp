// Converts settings of other slicers to options of Filum.
#pragma once

#include "cli/other_names.hpp"

#include <optional>
#include <string>

namespace filum::cli {

// The option, as one word of a command line, for a setting of another slicer: "--infill=15%" for fill-density 15. None
// if the value has no meaning in Filum. Throws Error(usage) for a value of the wrong kind.
std::optional<std::string> our_word(const OtherName& name, const std::string& value);

} // namespace filum::cli
