// Parts of a slicer's project from which negative bodies are cut away.
//
// The contours of the negative bodies are subtracted from those of the part, layer by layer.  That is exact for layers.
// It also works for open and self-intersecting meshes, where Boolean operations on triangles fail.
#pragma once

#include "mesh/read.hpp"
#include "slice/slice.hpp"

#include <memory>

namespace filum::app::slice {

struct CarvedPart {
    struct Cut {
        filum::slice::Part part;
        filum::slice::Sweep sweep{}; // refers to `part`
    };
    // Parts from which the same bodies are cut away. All parts without negative bodies form one group. Each body is a
    // solid by itself, whichever way its triangles face and however it meets others.
    struct Group {
        Cut part;
        std::vector<std::unique_ptr<Cut>> away;
    };
    std::vector<std::unique_ptr<Group>> groups;
    geom::Box3 box; // of the remaining material, mm
};

// Whether the file has negative bodies.
bool is_carved(const mesh::File& file);

// Prepares the parts of a placed file, and finds the box of the remaining material; its z is exact to 2.5 um.
// `hairline`: as in slice::Options; `step`: the thickness in mm below which remaining material may be missed. Throws
// Error(bad_input) if nothing remains.
CarvedPart carve(const mesh::File& file, double hairline, double step, int threads, Notes& notes);

// Prepares the cuts at `levels`; cut() needs them.
void sweep(CarvedPart& carved, const filum::slice::Options& options, const std::vector<filum::slice::Level>& levels,
           int threads);

// The layers of one chunk, as slice::cut returns them.
filum::slice::SlicedChunk cut(const CarvedPart& carved, std::size_t chunk);

// The mesh with all z clamped to the range of the box, so that it has the levels of the remaining material. Triangles
// that lose an edge by it are left out.
mesh::Mesh within_heights(mesh::Mesh mesh, const geom::Box3& box);

} // namespace filum::app::slice
