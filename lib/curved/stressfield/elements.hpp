// Division of elements into tetrahedra and triangles; private to lib/curved/stressfield.
#pragma once

#include "stressfield/samples.hpp"
#include "stressfield/triangle.hpp"

#include <span>

namespace filum::stressfield {

std::size_t node_count(Shape shape);
bool is_solid(Shape shape); // not a shell

// Triangles over all nodes of the faces of an element, as its node numbers. Four-sided faces are divided at the corner
// that comes first in Samples::points, so that adjacent elements agree.
void triangles_of(const Samples& samples, const Element& element, std::vector<Triangle>& out);

// The weights of the nodes of a solid element in its middle, by its shape functions.
void middle_weights(Shape shape, std::vector<double>& out);

inline std::span<const std::uint32_t> nodes_of(const Samples& s, const Element& e) {
    return std::span(s.nodes).subspan(e.first, node_count(e.shape));
}

// The triangles of shells, and of faces that belong to only one solid element.
struct Skin {
    std::vector<Triangle> triangles; // those of solids face outwards
    std::vector<bool> shell;         // per triangle
};
Skin skin(const Samples& samples);

} // namespace filum::stressfield
