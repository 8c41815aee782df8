// What of a surface is farther than a level, as it hangs together between the isolines of that level.
#pragma once

#include "geodesic/isolines.hpp"
#include "geom/disjoint_sets.hpp"

namespace filum::geodesic {

// Parts by the isolines as they run, not by what the vertices say: on large triangles a part may hold no vertex, and
// narrow ways lead between vertices that are nearer than the level.
class Beyond {
  public:
    Beyond(const Surface& surface, const ExactField& field, double level);

    // The part that holds the place, its border included; kNone if that is nearer than the level.
    [[nodiscard]] std::uint32_t part(const OnEdge& place) const;

    // mm: the greatest distance at a vertex of the part, or on edges that cross the level.
    [[nodiscard]] double highest(std::uint32_t part) const { return highest_[part]; }

  private:
    struct Stretch { // of an edge that crosses the level: what is farther
        std::uint32_t edge, node;
        double from, to; // mm from the tail of the lesser half-edge
    };
    void cut(std::uint32_t h, std::span<const double> crossings);
    [[nodiscard]] std::span<const Stretch> on(std::uint32_t half_edge) const;
    void join_across(const Inside& above);
    void join_across(std::uint32_t triangle, const Inside& above);

    const Surface& surface_;
    std::vector<char> far_;           // per vertex
    geom::DisjointSets sets_;         // of vertices, then of stretches that end at none; of no use for what is near
    std::vector<Stretch> stretches_;  // by edges, then ascending
    std::vector<std::uint32_t> part_; // per node
    std::vector<double> highest_;     // per part
};

} // namespace filum::geodesic
