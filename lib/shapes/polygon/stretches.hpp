// Lines y = const across an area.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::polygon {

// The points, rotated by `angle` rad about the origin.
Loops rotated(const Loops& loops, double angle);
void rotate(std::vector<Vec2>& points, double angle);

// A stretch of a line y = const that lies in the area, mm.
struct LevelStretch {
    double from = 0, to = 0;
};

// For each y (ascending) the stretches of that line inside `area` (even-odd), from left to right. An edge belongs to
// the lines lower <= y < upper, so that no vertex counts twice.
std::vector<std::vector<LevelStretch>> scan(const Loops& area, const std::vector<double>& y);

} // namespace filum::polygon
