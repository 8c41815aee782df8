// Places of parts in a grid, as in the wells of a plate.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace filum::plate {

using geom::Vec2;

// A grid of places. Columns 1, 2, 3 run from left to right; rows A, B, C run from the back to the front, as on well
// plates.
struct Grid {
    std::size_t columns = 0, rows = 0;
    Vec2 pitch;       // mm, between the middles of neighbouring places
    double depth = 0; // mm, from the bottom of a well to the top of its wall; 0: unknown
    Vec2 shift{};     // mm, from the middle of the plate to that of the grid

    [[nodiscard]] std::size_t size() const { return columns * rows; }
};

// The grid of a plate with 6, 12, 24, 48 or 96 wells. Pitch and depth are those of Corning's Costar plates; the 96-well
// pitch is that of ANSI SLAS 4. The plate measures 127.76 x 85.48 mm (ANSI SLAS 1). Throws Error(usage) for other
// numbers of wells.
Grid well_plate(std::int64_t wells);

// Parses "4x3": four columns and three rows. `pitch` holds one number or two, mm. Throws Error(usage).
Grid parse_grid(const std::string& text, const std::vector<double>& pitch);

// The name of a place: "B3" is the third column of the second row. Rows after Z are AA, AB, ...
std::string well_name(const Grid& grid, std::size_t index);

// The indices of the places in `names`, such as "A1,B3", in the order of the grid: A1, A2, ..., B1, ... An empty text
// names all places. Throws Error(usage) for a name that the grid does not have.
std::vector<std::size_t> wells_named(const Grid& grid, const std::string& names);

// The middle of a place, relative to the middle of the plate, mm.
Vec2 middle(const Grid& grid, std::size_t index);

} // namespace filum::plate
