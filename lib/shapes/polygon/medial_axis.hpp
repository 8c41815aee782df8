// The medial axis of a region, linked to its outline (Boost.Polygon's Voronoi diagram of segments).
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Every point of a region lies on a ray. The ray begins at the nearest point of the outline, its foot. It ends on the
// medial axis, where another part of the outline is equally near. The axis is cut into straight pieces between nodes.
// Piece e has two sides, the half-edges 2e and 2e + 1 (h and h ^ 1). Each belongs to one stretch of the outline and is
// directed along it, solid on the left. Following `next` goes once round a contour of the region. Pieces and nodes are
// numbered in the order of that walk, so that it reads memory in order. Only those that refined() adds come last.
struct MedialAxis {
    // per node
    std::vector<Vec2> node;     // mm
    std::vector<double> radius; // mm, to the outline; 0 at a convex corner
    // per half-edge
    std::vector<std::uint32_t> from; // its first node
    std::vector<std::uint32_t> next; // the next half-edge along the outline
    std::vector<Vec2> foot;          // of the ray to its first node

    [[nodiscard]] std::uint32_t half_edges() const { return static_cast<std::uint32_t>(from.size()); }
    [[nodiscard]] std::uint32_t nodes() const { return static_cast<std::uint32_t>(node.size()); }
    [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from[h ^ 1]; }
    // The foot of the ray to its last node.
    [[nodiscard]] Vec2 last_foot(std::uint32_t h) const { return foot[next[h]]; }
    [[nodiscard]] double length(std::uint32_t h) const { return geom::distance(node[from[h]], node[to(h)]); }
    // Rise of the radius per mm of the piece, absolute: the sine of half the angle between the two parts of the
    // outline.
    [[nodiscard]] double slope(std::uint32_t h) const;
};

// The medial axis of `region`. Vertices of the outline within `outline_tolerance` mm of the result are removed first
// (sites.hpp). Where the outline comes nearer to itself than a grid unit, the region may be grown by a micrometre,
// rarely by more. Curved pieces are cut so that positions and radii between nodes are linear to `tolerance` mm. They
// are also cut so that the radius rises or falls along each piece, and where its slope passes `slope`. Empty for a
// region without area. Throws Error(bad_input) for a region wider than 100 m.
MedialAxis medial_axis(const Loops& region, double outline_tolerance, double tolerance, double slope);

// The axis with nodes added on piece e at cuts[start[e]] .. cuts[start[e + 1]]. These are ascending shares in (0, 1) of
// its length, from the first node of its first side. Old nodes keep their numbers; the j-th cut becomes node
// axis.nodes() + j.
MedialAxis refined(const MedialAxis& axis, const std::vector<double>& cuts, const std::vector<std::uint32_t>& start);

} // namespace filum::polygon
