// Translates the speeds of walls that are partly over air.
#pragma once

#include "app/filum/slicer_values.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The option and the key of the machine for the speeds that a file gives to overhangs; none if it has them switched
// off. Shares are those of a bead's width over air; between them each slicer changes the speed linearly.
//
// PrusaSlicer 2.6 and newer (enable_dynamic_overhang_speeds): the wall's own speed at 0, overhang_speed_3 at 0.25,
// overhang_speed_2 at 0.5, overhang_speed_1 at 0.75 and overhang_speed_0 at 1. A speed of 0 is that of outer walls.
//
// OrcaSlicer (enable_overhang_speed): the own speed below 0.25, overhang_1_4_speed at 0.25, overhang_2_4_speed at 0.5,
// overhang_3_4_speed at 0.75, overhang_4_4_speed at 0.87, and above it bridge_speed, or with
// slowdown_for_curled_perimeters again overhang_4_4_speed. A speed of 0 is the own one.
//
// Bambu Studio, and OrcaSlicer with overhang_speed_classic, count in degrees from 0.1 to 1. Bambu Studio's are at 10,
// 25, 50, 75 and 100 % of that range, and overhang_totally_speed is that of walls wholly over air. Those of OrcaSlicer
// are a fifth of it apart, with bridge_speed at the end.
std::vector<std::string> overhang_words(const SlicerValues& values);

} // namespace filum::app::filum
