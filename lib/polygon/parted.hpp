// Segments on a grid of whole numbers, parted where they meet; private to lib/polygon.
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

// Positive if c lies left of a -> b, exact.  Precondition: coordinates differ by less than 2^62.
inline __int128 turn(GridPoint a, GridPoint b, GridPoint c) {
    return static_cast<__int128>(b.x - a.x) * (c.y - a.y) - static_cast<__int128>(b.y - a.y) * (c.x - a.x);
}

// From a to b, a < b.
struct GridWall {
    GridPoint a, b;
    int weight = 0; // times passed from a to b, less those from b to a
    bool marked = false;
    bool fresh = true; // not yet compared with the others
};

// The same walls in pieces that have no points in common but their ends, each piece once, by a, then b.  Crossings are
// rounded to the grid; what runs through a rounded point is bent there.  Nothing if that goes on for too long.
std::optional<std::vector<GridWall>> parted(std::vector<GridWall> walls);

} // namespace filum::polygon
