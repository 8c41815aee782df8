// The superlevel set of a distance, {distance >= level}, and its connected components.
#pragma once

#include "geodesic/isolines.hpp"
#include "geom/disjoint_sets.hpp"

namespace filum::geodesic {

// Components are bounded by the isolines as these run, rather than decided at vertices only: on large triangles a
// component may contain no vertex, and narrow passages may lead between vertices below the level.
class SuperlevelSet {
  public:
    SuperlevelSet(const Surface& surface, const ExactField& field, double level);

    // The component that contains the place, border included; kNone if the place is below the level.
    [[nodiscard]] std::uint32_t component(const EdgePlace& place) const;

    // mm: the greatest distance at vertices of the component and at the middles of its parts of crossed edges.
    [[nodiscard]] double highest(std::uint32_t component) const { return highest_[component]; }

  private:
    struct EdgePart { // a part of a crossed edge that is above the level
        std::uint32_t edge, node;
        double from, to; // mm from the tail of the half-edge of lower number
    };
    void cut(std::uint32_t h, std::span<const double> crossings);
    [[nodiscard]] std::span<const EdgePart> on(std::uint32_t half_edge) const;
    void join_across(const Inside& above);
    void join_across(std::uint32_t triangle, const Inside& above);

    const Surface& surface_;
    std::vector<char> far_; // per vertex: whether it is above the level
    // nodes: vertices, then edge parts that contain no vertex; those below the level are not used
    geom::DisjointSets sets_;
    std::vector<EdgePart> parts_;          // by edge, then ascending
    std::vector<std::uint32_t> component_; // per node
    std::vector<double> highest_;          // per component
};

} // namespace filum::geodesic
