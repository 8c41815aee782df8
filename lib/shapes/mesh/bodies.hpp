// Bodies: groups the shells of a mesh that bound one solid together, and turns them to face outwards.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// The bodies of a mesh. A body is the volume enclosed by a shell, less its cavities. The solid of the mesh is the union
// of its bodies.
struct Bodies {
    std::vector<std::uint32_t> of_vertex; // the vertex's body; bodies are numbered by their first vertices
    std::vector<char> hollow;             // per body: it has a cavity
    std::size_t shells = 0;
    bool closed = true; // false: some shell is open; then all shells form one body
};

// Turns shells so that they face outwards, and cavities so that they face inwards, judged by their signed volumes. If
// the whole mesh is nearly closed and its volume is negative, all of it is turned first. Then every nearly closed shell
// of negative volume is turned, unless it is a cavity. Each of these steps adds a note.
//
// A cavity lies inside its shell and leaves a wall of more than `least_wall` mm, averaged over that shell's area. A
// shell that leaves a thinner wall counts as a copy that faces the wrong way.
//
// `two_sided`: the mesh has lost its orientation (see part_sheets). Then shells inside an odd number of others are
// cavities, and turned shells add no note.
//
// Precondition: two triangles that share an edge run along it in opposite directions (see part_sheets and
// face_one_way).
Bodies face_outwards(Mesh& mesh, bool two_sided, double least_wall, Notes& notes);

} // namespace filum::mesh
