// The medial axis of a region, seen from its outline (Boost.Polygon's Voronoi diagram of segments).
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Every point of a region lies on a ray: from the nearest point of the outline, its foot, to where the inside is
// equally far from another part of the outline, which is the medial axis.  The axis is cut into straight pieces between
// nodes. Piece e has two sides, the half-edges 2e and 2e + 1 (h and h ^ 1), each seen from the stretch of outline that
// it belongs to and directed along it, solid on the left.  Following `next` goes once round a contour of the region.
// Pieces and nodes are numbered as one comes by them that way, but for those that refined() adds: who walks along the
// outline reads memory in order.
struct MedialAxis {
    // per node
    std::vector<Vec2> node;     // mm
    std::vector<double> radius; // mm, to the outline; 0 at a convex corner
    // per half-edge
    std::vector<std::uint32_t> from; // node that it begins at
    std::vector<std::uint32_t> next; // the one after it along the outline
    std::vector<Vec2> foot;          // of the ray to its first node

    [[nodiscard]] std::uint32_t half_edges() const { return static_cast<std::uint32_t>(from.size()); }
    [[nodiscard]] std::uint32_t nodes() const { return static_cast<std::uint32_t>(node.size()); }
    [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from[h ^ 1]; }
    // Of the ray to its last node.
    [[nodiscard]] Vec2 last_foot(std::uint32_t h) const { return foot[next[h]]; }
    [[nodiscard]] double length(std::uint32_t h) const { return geom::distance(node[from[h]], node[to(h)]); }
    // Rise of the radius along the piece per mm, absolute: the sine of half the angle between its two sides.
    [[nodiscard]] double slope(std::uint32_t h) const;
};

// The axis of `region`, whose outline is first rid of vertices within `outline_tolerance` mm of it (sites.hpp).  Where
// the outline comes nearer to itself than a grid unit, the region may be grown by a micrometre, seldom by more.  Curved
// pieces are cut so that positions and radii between nodes are linear to `tolerance` mm, that radii rise or fall along
// each piece, and where their slope passes `slope`. Empty for a region without area.  Throws Error(failure) for a
// region wider than 100 m.
MedialAxis medial_axis(const Loops& region, double outline_tolerance, double tolerance, double slope);

// The axis with nodes added: on piece e at cuts[start[e]] .. cuts[start[e + 1]], ascending shares in (0, 1) of its
// length from its first side's first node.  Nodes there were keep their numbers; the j-th cut becomes node
// axis.nodes() + j.
MedialAxis refined(const MedialAxis& axis, const std::vector<double>& cuts, const std::vector<std::uint32_t>& start);

} // namespace filum::polygon
