// Translates the speeds and the fan of walls that are partly over air.
#pragma once

#include "app/filum/slicer_values.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The option and the key of the machine that the setting `key` makes: for the speeds that a file gives to overhangs, or
// for the fan.  None if the file has them switched off, or if another key of the same kind makes them.  Shares are
// those of a bead's width over air; between them each slicer changes the speed linearly.
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
//
// Fans: with enable_dynamic_fan_speeds of PrusaSlicer none at share 0, overhang_fan_speed_3 at 0.25, _2 at 0.5, _1 at
// 0.75, _0 at 1, linear between.  In OrcaSlicer and Bambu Studio overhang_fan_speed from overhang_fan_threshold on, if
// enable_overhang_bridge_fan is set.  The fan is never slower than on the rest of the layer.
std::vector<std::string> overhang_words(const SlicerValues& values, const std::string& key,
                                        std::vector<std::string>& remarks);

} // namespace filum::app::filum
