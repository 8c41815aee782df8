// Sheets: what hangs together as a surface, where more than two triangles meet on an edge, or some are there twice.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// Makes each edge one of at most two triangles, which do not lie on each other, and tells about what it left out.
//
// Where more meet, those that bound the same solid on both sides of the edge go together: going round the edge from a
// triangle through the solid behind it, the next one whose solid is on the other side (the radial order of Weiler
// 1988).  Triangles that lie on each other never do: they are copies, not neighbours; of several copies the first goes
// with the first.  Sheets that so come apart get vertices of their own.
// A sheet all of whose triangles are there in a sheet before it, the same way round, or either way if it is open, is
// left out.  If every triangle is there both ways round, one of each is left, and true is returned: what of such a mesh
// is outside, its triangles do not say.
// A mesh without such edges is not changed, at some 5 ns per side.
bool part_sheets(Mesh& mesh, Notes& notes);

} // namespace filum::mesh
