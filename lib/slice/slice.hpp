// A mesh to closed contours per layer.
//
// The sweep calls a vertex above a plane or not above it, so that no vertex is ever on a plane: every triangle that a
// plane meets gives exactly one piece of contour, from one edge to another, and the pieces of a closed mesh always
// close.  Tie rule: a face level with a plane counts as below it, so that the section is that of the upper half of the
// layer: the floor over a recess is there, and a step that ends half way up is not.
#pragma once

#include "base/note.hpp"
#include "mesh/bodies.hpp"
#include "mesh/holes.hpp"
#include "mesh/mesh.hpp"
#include "mesh/winding.hpp"
#include "polygon/region.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace filum::slice {

struct Options {
    double layer_height = 0.2;     // mm
    double first_layer_height = 0; // mm, 0: as layer_height
    bool adaptive = false;         // layer heights from the slope of the surface
    double min_layer_height = 0.1; // mm, of adaptive layers
    double max_layer_height = 0.3; // mm
    double cusp = 0.1;             // mm, greatest distance between the surface and the steps of adaptive layers
    double close_gaps = 0.2;       // mm; gaps in contours up to here are closed
    double close_openings = 0.5;   // wider ones are closed straight up to this part of the contour's length
    double hairline = 0.05; // mm; gaps between bodies, and what bodies leave of each other, below this are healed
};

// Where one layer is cut, and where the nozzle runs.
struct Level {
    double z = 0;      // top of the layer, mm
    double height = 0; // mm
    double plane = 0;  // mid-height
};

// Planes are cut this much higher: more than a mesh is rounded or jittered by (1 um at each end), less than shows.
inline constexpr double kLift = 2.5e-3; // mm

// The levels of a part that reaches from z = bottom to z = top, lowest first.  Without `adaptive` there are
// round(height / layer_height) of them, half a layer rounded down, the first as high as asked for.  A part lower than
// half a layer is an Error(bad_input), as are more than a million layers; one lower than a layer gets one, cut at the
// part's own mid-height, with a note. With `adaptive`, a layer of height h on a surface whose unit normal has vertical
// part n_z leaves steps h |n_z| off the surface (cusp height, Dolenc and Makela 1994): each is the highest within the
// limits that keeps it below `cusp` on the slopes it spans, but for the steepest 5 % of the area and for level faces;
// neighbours differ by less than a third.  At most 100000 of them.
std::vector<Level> levels(const mesh::Mesh& mesh, const Options& options, Notes& notes);

// Layers that are cut together.
inline constexpr std::size_t kChunk = 8;

// A mesh made ready: in sheets that face one way and outwards, with lids for its holes; what was turned round or left
// out is noted.
struct Part {
    mesh::Mesh mesh;
    mesh::Bodies bodies;
    std::vector<mesh::Triangle> lids;               // used where a contour ends at a hole
    std::vector<mesh::Hole> holes;                  // that have a lid
    std::shared_ptr<const mesh::Winding> winding{}; // of the mesh and its lids; none if it is closed
};
// A shell within another that leaves no wall of `least_wall` mm, taken over all, is a copy of it and no cavity.
// Precondition: `mesh` is as mesh::read and mesh::place leave it.
Part make_part(mesh::Mesh mesh, Notes& notes, double least_wall = Options{}.hairline);

// Everything that cutting needs to know of a mesh, made once; refers to the part.
struct Sweep {
    const Part* part = nullptr;
    Options options;
    std::vector<Level> levels;
    double top = 0;                         // of the part, mm
    std::vector<std::uint32_t> rank;        // per vertex: the number of planes it is above
    std::vector<std::uint64_t> chunk_start; // per chunk of layers: where its triangles begin in `triangles`
    std::vector<std::uint32_t> triangles;   // met by a plane of the chunk, by ascending number

    [[nodiscard]] std::size_t chunks() const { return chunk_start.size() - 1; }
};

// Throws Error as levels(), and if the contours of all layers together would have more than 2^32 points.
Sweep prepare(const Part& part, const Options& options, int threads, Notes& notes);
// The same for levels of any kind, lowest first.
Sweep sweep_over(const Part& part, const Options& options, std::vector<Level> levels, int threads);

// The layers of one chunk, lowest first, each with what was repaired in it.  Chunks are independent of each other, and
// their contours do not depend on the chunking.  Contours are simple, on a grid of 0.1 um, solid on the left.
struct Cut {
    std::vector<polygon::Layer> layers;
    Notes notes;
};
Cut cut(const Sweep& sweep, std::size_t chunk);

// All of it: the layers of `part`, lowest first, judged and compared (see volume.hpp).
std::vector<polygon::Layer> slice(const Part& part, const Options& options, Notes& notes, int threads = 1);

} // namespace filum::slice
