// Splits segments on a grid of whole numbers where they meet. Private to lib/shapes/polygon.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace filum::polygon {

struct GridPoint {
    std::int64_t x = 0, y = 0;
    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

// Positive if c lies left of a -> b; exact. Precondition: coordinates differ by less than 2^62.
inline __int128 turn(GridPoint a, GridPoint b, GridPoint c) {
    return static_cast<__int128>(b.x - a.x) * (c.y - a.y) - static_cast<__int128>(b.y - a.y) * (c.x - a.x);
}

// A segment from a to b, a < b.
struct GridWall {
    GridPoint a, b;
    int weight = 0; // number of passes from a to b, less those from b to a
    bool marked = false;
    bool fresh = true; // not yet compared with the others
};

// The walls in pieces that share no points except their ends, each piece once, sorted by a, then b. Crossings are
// rounded to the grid; a wall through a rounded point is bent there. Nothing if this does not end within a fixed number
// of passes.
std::optional<std::vector<GridWall>> parted(std::vector<GridWall> walls);

} // namespace filum::polygon
