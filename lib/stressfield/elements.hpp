// Elements cut into tetrahedra and triangles; private to lib/stressfield.
#pragma once

#include "stressfield/samples.hpp"
#include "stressfield/triangle.hpp"

#include <span>

namespace filum::stressfield {

std::size_t node_count(Shape shape);
bool is_solid(Shape shape); // not a shell

// The triangles that cover the faces of an element, of all its nodes, as its node numbers.  Four-sided faces are cut
// from the corner that comes first in Samples::points, so that neighbours agree.
void triangles_of(const Samples& samples, const Element& element, std::vector<Triangle>& out);

// What the point in the middle of a solid element is made of: weights of its nodes, by its shape functions.
void middle_weights(Shape shape, std::vector<double>& out);

inline std::span<const std::uint32_t> nodes_of(const Samples& s, const Element& e) {
    return std::span(s.nodes).subspan(e.first, node_count(e.shape));
}

// The triangles of shells and of all faces that one solid element only has.
struct Skin {
    std::vector<Triangle> triangles; // of solids, they face out
    std::vector<bool> shell;         // per triangle
};
Skin skin(const Samples& samples);

} // namespace filum::stressfield
