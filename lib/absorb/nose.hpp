// Noses: corners and other points of the curve pulled out, narrower or wider, into the void beside them.
#pragma once

#include "absorb/course.hpp"
#include "absorb/voids.hpp"

#include <optional>

namespace filum::absorb {

// Where a nose may begin.
struct Root {
    std::uint32_t from = 0, to = 0;
    std::optional<std::uint32_t> vertex; // the node between them, none if they are the ends of one segment
    Vec2 at;                             // the vertex or a point of the segment
    double width = 0;                    // mm, of the bead there
};

// How to look for the best course.
struct Search {
    double width = 0.4;    // mm: the bead width
    Prices prices;         //
    bool small = false;    // a region where single voids matter much: every root and shape
    bool thorough = false; // ears, too, and on small regions every nose, not only those that are best most often
    double enough = 1e9;   // pixels: a course with this score ends the search
    [[nodiscard]] bool done(const std::vector<Course>& found) const {
        return !found.empty() && found.back().score >= enough;
    }
};

// The places of the curve from which a nose might reach the void: sharp corners, then the nearest points.
std::vector<Root> roots(const Tile& tile, const Chain& chain, const Near& near, const Void& v, const Search& search);

// Adds the courses from `root` that are worth it:
// noses, the point itself moved into the void with the curve bent on both sides of it;
void noses(const Tile& tile, const Chain& chain, const Root& root, const Void& v, const Search& search,
           std::vector<Course>& out);
// blades, where the curve turns back after a short leg: the leg narrower, farther out, and into both corners;
void blades(const Tile& tile, const Chain& chain, const Root& root, const Search& search, std::vector<Course>& out);
// ears, a narrow lane out of a corner and back.
void ears(const Tile& tile, const Chain& chain, const Root& root, const Search& search, std::vector<Course>& out);

} // namespace filum::absorb
