// Parts of a slicer's project from which negative bodies are cut away.
//
// Bodies are cut away layer by layer, from the contours: that is exact where layers are all that counts, and meshes
// that no Boolean operation on triangles would take, open or crossing themselves, need no other way.
#pragma once

#include "mesh/read.hpp"
#include "slice/slice.hpp"

#include <memory>

namespace filum::app::slice {

struct Carved {
    // The parts that the same bodies are cut away from; all parts that nothing is cut away from are one group.
    struct Group {
        filum::slice::Part part, away;
        filum::slice::Sweep of_part, of_away; // refer to the above
        bool cut = false;                     // something is cut away
    };
    std::vector<std::unique_ptr<Group>> groups;
    geom::Box3 box; // of what is left
};

// Whether bodies of the file are to be cut away.
bool is_carved(const mesh::File& file);

// Makes the parts of a placed file ready, and finds the box of what is left of them, in z to 2.5 um.  `hairline` as in
// slice::Options; `step`: mm, the thickness below which parts may be overlooked.
// Throws Error(bad_input) if nothing is left.
Carved carve(const mesh::File& file, double hairline, double step, int threads, Notes& notes);

// Makes the levels ready to be cut.
void sweep(Carved& carved, const filum::slice::Options& options, const std::vector<filum::slice::Level>& levels,
           int threads);

// The layers of one chunk, as slice::cut.
filum::slice::Cut cut(const Carved& carved, std::size_t chunk);

// The mesh with all heights outside the box brought to its bottom or top: it has the levels of what is left.
mesh::Mesh within_heights(mesh::Mesh mesh, const geom::Box3& box);

} // namespace filum::app::slice
