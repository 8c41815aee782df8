// What other slicers call the options of Filum, and what Filum called them before.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace filum::cli {

// "; here it is '--bead-width'" for an option as PrusaSlicer, OrcaSlicer, Cura or Slic3r name it (with '-' or '_'), if
// ours is among `names`, without dashes; else "".
std::string in_our_words(std::string_view name, std::span<const std::string> names);

} // namespace filum::cli
