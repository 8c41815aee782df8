// Minimum spanning trees of isocontours (section 3.2.1).
#pragma once

#include "baselines/kipping2022/contours.hpp"
#include "baselines/kipping2022/options.hpp"
#include "geom/point_tree.hpp"
#include "surface/sheet.hpp"

namespace filum::baselines::kipping2022 {

// A closed contour, resampled.
struct Node {
    Contour contour;       // without its points
    geom::PointTree cloud; // its points in order
    std::uint32_t component = 0;
    std::vector<std::uint32_t> neighbours{}; // in the spanning tree, ascending

    [[nodiscard]] const Points& points() const { return cloud.points(); }
};

struct Tree {
    std::vector<Node> nodes;          // by level, then in the order of isolines
    std::vector<std::uint32_t> roots; // of each tree: the outermost contour, ascending by component
};

// The isocontours at i d of the distance from the rims, and their trees. Open ones, which exist only where the field
// is not 0 at rims, are left out with a note.
// Throws Error(bad_input) if the surface has no rim, Error(usage) if the distance is not that from all rims, or if no
// level is on the surface.
Tree tree(const surface::Sheet& sheet, const std::vector<double>& phi, const Options& settled, Notes& notes);

} // namespace filum::baselines::kipping2022
