// The moves that bring a machine with rotary axes to its first stroke.
#pragma once

#include "postproc/lifts.hpp"

namespace filum::postproc {

// Returns `stroke`, whose first pose is above its start, with poses before it that lead there from kinematics.start.
// First Z moves alone to the height of kinematics.start or of the first pose, whichever is higher.  At that height all
// other axes move, straight.  Then Z moves alone down to the first pose.  If the program's numbers are tips, the middle
// part has a pose every 2 degrees, so that the tip keeps to its arc.
// `added`: the number of new poses.  Without kinematics.start nothing changes.
Motion approached(const machine::Profile& profile, Motion stroke, std::size_t& added);

} // namespace filum::postproc
