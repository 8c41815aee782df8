// The planar construction of S. Sun, Y. Yao, Y. Jiang, "A 3D Continuous Path Generation Method and Evaluation for Fused
// Deposition Manufacturing in Tissue Engineering", 2019, section 3.2, exactly as described there, for comparison.
// Nothing is improved: beads leave voids or overlap at the medial axis, necks narrower than a bead split the region,
// links may cross, and where the contour graph falls apart there are several curves.
//
// Where the text leaves room, these readings are used:
//  - "each contour is sampled equidistantly": corners are kept, and each edge is divided evenly into the fewest steps
//    of at most `sample` offsets.
//  - "internal filling contour is generated from outer contour R, d(r_n, r_n+1) = w": the first contour lies `first`
//    offsets inside the outline, half a bead, or the part would come out larger than the model; the rest follow at w.
//  - "minimum distance between any vertex in contour 1 and any vertex in contour 2; threshold set to 1-2 times w":
//    `threshold` offsets, at most.  "The corresponding element is set to 1": all edges weigh the same.
//  - "contour index starts from 1, from the external contour": depth by depth, in a depth the largest signed area
//    first.
//  - "Reverse-delete": edges go one by one, later index pairs first, unless the graph would fall apart.
//  - "merge nodes that contain only one-way parent-child relationships": maximal chains of contours with one child
//    each.
//  - "connect the two contour sets sequentially and connect the endpoints of the two contour sets" (Figure 5a): in a
//    chain the odd contours are joined inwards and the even ones outwards, linked at the centre, as in the Fermat
//    spirals that the section builds on (its reference 12); each contour is opened by one offset.
//  - "insert the continuous paths of all child nodes into the parent node", from the bottom up: the parent's path is
//    cut between the vertex nearest the child's ends and that vertex's neighbour, whichever links are shorter.
//  - PCA (Figure 6): the axis of greatest variance of all contour samples; the path starts where it leaves the outer
//    contour, towards +x (+y if vertical).  A child starts at its vertex nearest the parent.
//  - the result stays open, from its start to its end one lane further in: section 3.3 joins layers there.
#pragma once

#include "base/note.hpp"
#include "fill/reuse.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::baselines::sun2019 {

struct SpiralOptions {
    double offset = 0.4;    // mm, the paper's omega; also the bead width
    double threshold = 1.5; // offsets, the paper's 1-2: contours with vertices this near are adjacent
    double sample = 1.0;    // offsets, longest step between samples
    double first = 0.5;     // offsets, depth of the first contour
    double start_shift = 0; // mm, how far along the outer contour the start is moved from the axis (section 3.3)
};

// Open curves, one per connected piece of the contour graph, that of the outer contour first.
// Parts narrower than a bead carry no contour; they become a note.
std::vector<toolpath::Curve> spiral(const polygon::Loops& region, const SpiralOptions& options, Notes& notes);

// A filler for regions with it; starts move on by `start_shift` from layer to layer.
fill::Reuse filler(const SpiralOptions& options);

} // namespace filum::baselines::sun2019
