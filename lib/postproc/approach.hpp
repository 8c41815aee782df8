// How a machine with rotary axes comes to its first stroke.
#pragma once

#include "postproc/lifts.hpp"

namespace filum::postproc {

// `stroke`, whose first pose is above its first place, with poses before it: from kinematics.start, where the axes are
// taken to stand, Z alone to the height of that or of the first pose, whichever is higher; there all other axes,
// straight; then Z alone down to the first pose.  Where numbers are tips the middle part has a pose every 2 degrees, so
// that the tip does not take a chord.  `added`: how many.  Without kinematics.start nothing changes.
Motion approached(const machine::Profile& profile, Motion stroke, std::size_t& added);

} // namespace filum::postproc
