// Bodies: which shells of a mesh bound one solid together, and which way they face.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// The solid of a mesh is that of its bodies together; a body is what a shell encloses, less its cavities.
struct Bodies {
    std::vector<std::uint32_t> of_vertex; // numbered by their first vertices
    std::vector<char> hollow;             // per body: it has a cavity
    std::size_t shells = 0;
    bool closed = true; // every shell is; if not, all of them are one body, as nobody knows what bounds what
};

// Turns shells so that they face outwards, and cavities so that they face inwards, as far as their volumes tell, with a
// note: the whole if its volume is negative, then every nearly closed shell of negative volume unless it is a cavity.
// A cavity lies within the shell that it is a cavity of, and leaves a wall of more than `least_wall` mm, taken over all
// of that shell; a shell that leaves less is a copy of it that faces the wrong way.
// `two_sided`: the mesh has lost its directions (see part_sheets): shells within an odd number of others are cavities.
// Precondition: sides that two triangles have in common run against each other, see part_sheets and face_one_way.
Bodies face_outwards(Mesh& mesh, bool two_sided, double least_wall, Notes& notes);

} // namespace filum::mesh
