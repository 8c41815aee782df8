// The direction and strength of tension on a surface.
#pragma once

#include "surface/directions/cells.hpp"
#include "surface/sheet.hpp"

#include <string>

namespace filum::surface::directions {

struct Pull {
    std::vector<Vec3> along;   // per vertex, unit, tangential, without sign; (0, 0, 0): unknown
    std::vector<double> load;  // per vertex, MPa (or the vector's length); 0 where there is no tangential tension
    std::vector<double> trust; // per vertex, 0 to 1: reliability of the direction
    [[nodiscard]] bool known(std::size_t vertex) const { return norm(along[vertex]) > 0; }
};

struct PullOptions {
    enum class Basis : std::uint8_t { either, stress, shape };
    Basis by = Basis::either; // stress; shape: no tension anywhere; either: stress if there is any, otherwise shape
    std::vector<std::string> cases; // empty: all
    std::string field;              // name of a vector field used instead of stresses; empty: stresses
};

// For every load case stress.CASE the greatest principal stress s1 along d1 contributes s1 (d1 . p)^2 in the tangent
// plane, where p is the direction of d1 in it; at each vertex the case with the greatest contribution counts (ties:
// the first). Trust is the load relative to the 90th percentile over the area.
// Throws Error(usage) if a field or case is missing, or if there is no stress with `Basis::stress`; Error(bad_input)
// if a field has the wrong kind.
Pull pull(const surface::Sheet& sheet, const Cells& cells, const PullOptions& options);

// Smooths the directions and extends them to where they are unknown. z, the doubled angle of the direction in the
// tangent plane, minimises the integral of trust |z - given|^2 + length^2 |grad z|^2; neighbours are compared after
// transport between their tangent planes. Trust is updated: |z| times at least a fifth. Components without any
// direction stay unchanged. (Knoppel, Crane, Pinkall, Schroeder 2013, "Globally optimal direction fields", with a data
// term.)
void smooth(Pull& pull, const Cells& cells, double length);

} // namespace filum::surface::directions
