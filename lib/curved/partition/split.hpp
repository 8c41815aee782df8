// Splits sheets with their fields into parts.
#pragma once

#include "partition/relax.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::partition {

using surface::Sheet;

// The given triangles of the sheet, in this order, with its fields and faces; without name, isolines and sources.
// Triangles are not joined across edges for which `apart` (per half-edge of the sheet, either half; may be empty) is
// set; separated fans get vertices of their own.
Sheet take(const Sheet& sheet, std::span<const std::uint32_t> triangles, std::span<const char> apart = {});

struct Parts {
    Sheet sheet;
    std::vector<std::uint32_t> patch; // per triangle
};

// The sheet with triangles split along borders, so that each belongs to the patch of its corners. Where three patches
// meet in a triangle, they meet in the mean of the three places on its sides. Fields are interpolated, vectors as
// directions without sign.
Parts split(const Sheet& sheet, const Cells& cells, const Borders& borders);

// Per triangle the number of its connected piece of a patch, by first triangles.
std::vector<std::uint32_t> pieces(const Parts& parts);

} // namespace filum::partition
