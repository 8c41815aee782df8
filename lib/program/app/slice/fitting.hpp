// Finds parts that look like bodies of one construct.
#pragma once

#include "app/slice/plate.hpp"

namespace filum::app::slice {

// A note on the parts that fit into each other as their files place them: they touch or interlock, but share no
// material.  Such files are mostly bodies of one part, which --body prints together, and here they are put side by
// side. Two parts fit if their boxes meet in the coordinates of their files, and their sections at five heights in
// common overlap by less than a hundredth of the smaller ones.  `parts` must be different files.
Notes fitting_parts(const std::vector<BedPart>& parts, int threads);

} // namespace filum::app::slice
