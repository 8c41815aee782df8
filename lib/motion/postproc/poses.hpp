// The number of poses of a stroke on a machine with rotary axes: more where the axes would lead the tip off its line,
// fewer where they would not.
#pragma once

#include "postproc/lifts.hpp"

namespace filum::postproc {

// Adds poses to `motion` if the program's numbers are joints.  Between two poses the axes move straight, so the tip
// leaves its line; the new poses keep it within the profile's chord, rounding to the last decimals included.  Legs that
// are not straight keep their joints.  So do the poses up to `stay`, as another tool may reach them.
// `landing`, the index of a leg, is updated to the leg's new index.
Motion refined(const machine::Profile& profile, Motion motion, std::size_t stay, std::size_t& landing);

// Removes the poses of `motion` that the profile's Merging makes unnecessary.  At each removed pose, and halfway to the
// next one, tip and tool axis are compared with the original ones at that share of the way.  They differ by at most the
// tolerances of the Merging.  Legs of different kinds, roles, tools, layers or feeds are not merged.  Legs whose
// sections differ by more than toolpath::Tolerance allows are not merged either.
// `off`: raised to the largest distance of the tip from its place.  Poses up to `stay` and the leg `landing` stay.
Motion fewer(const machine::Profile& profile, Motion motion, std::size_t stay, std::size_t& landing, double& off);

} // namespace filum::postproc
