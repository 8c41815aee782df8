// Sheets cut into parts, with all they carry.
#pragma once

#include "partition/relax.hpp"
#include "surface/sheet.hpp"

#include <span>

namespace filum::partition {

using surface::Sheet;

// Those triangles of the sheet, in this order, with its fields and faces; name, lines and sources stay behind.  Where
// `apart` (per half-edge of the sheet; none: nowhere) is set on either half, the triangles beside an edge are not
// joined; fans that are not joined any more get vertices of their own.
Sheet take(const Sheet& sheet, std::span<const std::uint32_t> triangles, std::span<const char> apart = {});

struct Parts {
    Sheet sheet;
    std::vector<std::uint32_t> patch; // per triangle
};

// The sheet with triangles across borders split where those lie, so that each belongs to the patch of its corners.
// Where three patches meet in a triangle, the point is the mean of the three places on its sides.  Fields are
// interpolated: vectors without their sign.
Parts split(const Sheet& sheet, const Cells& cells, const Borders& borders);

// Per triangle the number of its connected piece of a patch, by first triangles.
std::vector<std::uint32_t> pieces(const Parts& parts);

} // namespace filum::partition
