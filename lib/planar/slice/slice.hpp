// Slices a mesh into closed contours per layer.
//
// The sweep classifies every vertex as above a plane or not above it, so no vertex is ever on a plane. Every triangle
// that a plane meets gives exactly one piece of contour, from one edge to another. So the pieces of a closed mesh
// always close.
//
// Tie rule: a face level with a plane counts as below it, so the section is that of the upper half of the layer. A
// layer includes the floor over a recess, but not a step that ends half way up.
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
    bool adaptive = false;         // choose layer heights by the slope of the surface
    double min_layer_height = 0.1; // mm, of adaptive layers
    double max_layer_height = 0.3; // mm
    double cusp = 0.1;             // mm, largest distance between the surface and the steps of adaptive layers
    double close_gaps = 0.2;       // mm; gaps in contours up to here are closed
    double close_openings = 0.5;   // wider ones are closed up to this fraction of the contour's length
    double hairline = 0.05;        // mm; narrower gaps between bodies and slivers of bodies are healed
};

// The heights of one layer: where it is cut, and where the nozzle runs.
struct Level {
    double z = 0;      // top of the layer, mm
    double height = 0; // mm
    double plane = 0;  // mid-height
};

// Planes are cut this much higher. It exceeds the rounding or jitter of a mesh (1 um at each end) and is too small to
// be visible.
inline constexpr double kLift = 2.5e-3; // mm

// The levels of a part from its lowest to its highest point, lowest first.
//
// Without `adaptive` there are round(height / layer_height) levels, where half a layer is rounded down. The first one
// has the requested height. A part lower than the first layer gets one level, cut at half of the part's own height,
// with a note.
//
// With `adaptive`, a layer of height h on a surface leaves steps of h |n_z|, where n_z is the vertical part of the unit
// normal (cusp height, Dolenc and Makela 1994). Each layer is the highest within the limits that keeps its steps below
// `cusp`. The steepest 5 % of the area at one height and level faces do not count. Heights of neighbours differ by less
// than a third.
//
// Throws Error(bad_input) for a part lower than half a layer, and for more than a million layers, or 100000 adaptive
// ones. Throws Error(usage) if the limits of adaptive heights contradict each other.
std::vector<Level> levels(const mesh::Mesh& mesh, const Options& options, Notes& notes);

// The number of layers that are cut together.
inline constexpr std::size_t kChunk = 8;

// A mesh prepared for slicing: its sheets face one way and outwards, and its holes have lids. Notes report what was
// turned or left out.
struct Part {
    mesh::Mesh mesh;
    mesh::Bodies bodies;
    std::vector<mesh::Triangle> lids;               // where a contour ends at a hole, it continues along these
    std::vector<mesh::Hole> holes;                  // the holes that have a lid
    std::shared_ptr<const mesh::Winding> winding{}; // of the mesh and its lids; none if it is closed
};
// Prepares a mesh. A shell inside another one is a copy, not a cavity, if the wall between them is at most `least_wall`
// mm thick on average. Precondition: `mesh` comes from mesh::read and mesh::place.
Part make_part(mesh::Mesh mesh, Notes& notes, double least_wall = Options{}.hairline);

// The data for cutting a mesh, computed once. It refers to the part.
struct Sweep {
    const Part* part = nullptr;
    Options options;
    std::vector<Level> levels;
    double top = 0;                         // of the part, mm
    std::vector<std::uint32_t> rank;        // per vertex: the number of planes below it
    std::vector<std::uint64_t> chunk_start; // per chunk of layers: its first index in `triangles`
    std::vector<std::uint32_t> triangles;   // the triangles that a plane of the chunk meets, in ascending order

    [[nodiscard]] std::size_t chunks() const { return chunk_start.size() - 1; }
};

// Computes the levels and the sweep over them. Throws the errors of levels(), and Error(bad_input) if the contours of
// all layers together would have more than 2^32 points.
Sweep prepare(const Part& part, const Options& options, int threads, Notes& notes);
// The sweep over the given levels, lowest first.
Sweep sweep_over(const Part& part, const Options& options, std::vector<Level> levels, int threads);

// The layers of one chunk, lowest first, with notes on their repairs. Chunks are independent, and contours do not
// depend on the chunking. Contours are simple, on a grid of 0.1 um, with the solid on the left.
struct SlicedChunk {
    std::vector<polygon::Layer> layers;
    Notes notes;
};
SlicedChunk cut(const Sweep& sweep, std::size_t chunk);

// Slices the whole part.  Returns its layers, lowest first, judged and compared (see volume.hpp).
std::vector<polygon::Layer> slice(const Part& part, const Options& options, Notes& notes, int threads = 1);

} // namespace filum::slice
