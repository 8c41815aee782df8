// Settings of other slicers as options of Filum.
#pragma once

#include "cli/other_names.hpp"

#include <optional>
#include <string>

namespace filum::cli {

// The word for a setting of theirs with a value of theirs: "--infill=15%" for fill-density 15; none if the value has no
// meaning here.  Throws Error(usage) for a value of another kind.
std::optional<std::string> our_word(const OtherName& name, const std::string& value);

} // namespace filum::cli
