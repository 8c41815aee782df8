// Places of parts in a grid, as in the wells of a plate.
#pragma once

#include "geom/vec.hpp"

#include <string>
#include <vector>

namespace filum::plate {

using geom::Vec2;

// Columns are counted from left to right, 1 2 3, rows from the back to the front, A B C, as on plates of wells.
struct Grid {
    std::size_t columns = 0, rows = 0;
    Vec2 pitch;       // mm, from middle to middle
    double depth = 0; // mm, from the bottom of a well to the top of its wall; 0: unknown
    Vec2 shift{};     // mm, of the grid's middle from that of the plate

    [[nodiscard]] std::size_t size() const { return columns * rows; }
};

// A plate of 6, 12, 24, 48 or 96 wells: its pitch and depth as Corning's Costar plates have them; 96 as ANSI SLAS 4.
// The plate is 127.76 x 85.48 mm (ANSI SLAS 1).  Throws Error(usage) for others.
Grid well_plate(std::int64_t wells);

// "4x3", four columns and three rows, with a pitch of one number or two.  Throws Error(usage).
Grid parse_grid(const std::string& text, const std::vector<double>& pitch);

// "B3" of the third column in the second row; rows behind Z are AA, AB, ...
std::string well_name(const Grid& grid, std::size_t index);

// The places named by "A1,B3", in the order of the grid: A1, A2, ..., B1, ...; all if the text is empty.
// Throws Error(usage) for a name that the grid does not have.
std::vector<std::size_t> wells_named(const Grid& grid, const std::string& names);

// Where the middle of a place is, from the middle of the plate, mm.
Vec2 middle(const Grid& grid, std::size_t index);

} // namespace filum::plate
