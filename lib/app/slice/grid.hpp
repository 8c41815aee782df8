// Parts in the places of a grid, as in the wells of a plate.
#pragma once

#include "app/slice/plate.hpp"
#include "cli/spec.hpp"

#include <string>
#include <vector>

namespace filum::app::slice {

// The options that put several parts on a bed.
std::vector<cli::Option> plate_options(Options& options);

// How often each of `inputs` parts is made: in a grid one part stands in each place, or as many parts as places.
// Throws Error(usage) for other numbers of parts, and for --copies beside a grid.
std::size_t copies(const Options& options, std::size_t inputs);

// Where the parts stand in the grid: the middle of each part's box over the middle of its place.  `names` get those of
// the places.  Throws Error(bad_input) for a part larger than the distance of places.
std::vector<plate::Place> in_places(const std::vector<OnBed>& parts, const Options& options,
                                    std::vector<std::string>& names);

} // namespace filum::app::slice
