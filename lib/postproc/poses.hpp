// How many poses a stroke of a machine with rotary axes needs: more where its axes would lead the tip astray, fewer
// where they would not.
#pragma once

#include "postproc/lifts.hpp"

namespace filum::postproc {

// Of programs of joints: `motion` with as many poses more, on the straight ways of tips, as keep the tip within the
// profile's chord (its last decimals included) while the axes go straight from one to the next.  Others, and the
// joints of ways that are not straight, stay as they are; so do the poses up to `stay`, which another tool may reach.
// `landing`, the index of a leg, goes along.
Motion refined(const machine::Profile& profile, Motion motion, std::size_t stay, std::size_t& landing);

// `motion` without the poses that moves within the profile's Merging do not need: at each pose that is left out, and in
// the middle to the next, the tip is off by at most the tolerance from where it was at that share of the way, and the
// axis as much as the Merging says.  Legs of other kinds, roles, tools, layers or feeds are not merged, nor sections
// that differ by more than toolpath::Tolerance says.  `off`: grows to the farthest that the tip is off.
// The poses up to `stay` and the leg `landing` stay.
Motion fewer(const machine::Profile& profile, Motion motion, std::size_t stay, std::size_t& landing, double& off);

} // namespace filum::postproc
