// Places parts in a grid, such as in the wells of a plate.
#pragma once

#include "app/slice/plate.hpp"
#include "cli/spec.hpp"

#include <string>
#include <vector>

namespace filum::app::slice {

// The options that put several parts on the bed of a machine, and several bodies into a part.
std::vector<cli::Option> plate_options(Options& options);

// The number of copies of each of `inputs` parts.  In a grid, a single part gets a copy in each place; several parts
// must be as many as there are places.  Throws Error(usage) for other numbers of parts, and for --copies with a grid.
std::size_t copies(const Options& options, std::size_t inputs);

// The places of the parts in the grid.  The centre of each part's box is over the centre of its place.  `names`:
// each becomes PART_PLACE, such as "part_A1".  Throws Error(bad_input) for a part that is larger than the pitch of the
// grid.
std::vector<plate::Place> in_places(const std::vector<BedPart>& parts, const Options& options,
                                    std::vector<std::string>& names);

} // namespace filum::app::slice
