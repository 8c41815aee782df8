// Places a mesh for printing: unit, size, orientation, position.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "mesh/mesh.hpp"

#include <string>

namespace filum::mesh {

using geom::Affine;

// The steps of a placement, in the order in which they apply.
struct Placement {
    std::string unit = "mm";                 // unit of the file: um, mm, cm, m, in, or auto (guessed from the size)
    std::vector<double> scale{1};            // one factor, or one per axis; negative ones mirror
    std::vector<double> rotate_deg{0, 0, 0}; // about the x axis, then y, then z, all through the origin
    std::vector<double> translate{0, 0, 0};  // mm
    std::vector<double> center{};            // mm, x and y of the middle of the box; empty: not moved
    bool on_bed = true;                      // true: the lowest point moves to z = 0
    bool keep_z = false;                     // true: z stays, and on_bed has no effect
};

// The map that rotates about the x axis, then y, then z, and then translates. `rotate_deg` in degrees and `translate`
// in mm have three numbers each.
Affine rigid(const std::vector<double>& rotate_deg, const std::vector<double>& translate);

using geom::Box3;
Box3 bounds(const Mesh& mesh); // precondition: a vertex

inline constexpr double kMaxCoordinate = 1e7; // mm

struct PlacementMap {
    Affine map;      // from the file's coordinates
    double unit = 1; // mm per unit of the file
};

// Moves `mesh` as `placement` says and returns the map. `in_mm`: the file states its unit itself, so only "auto" and
// "mm" are allowed. If the map mirrors, the triangles are flipped, so that they still face outwards. Vertices without a
// triangle are dropped. Throws Error: usage for invalid options, bad_input if a coordinate ends up beyond 1e7 mm.
PlacementMap place(Mesh& mesh, const Placement& placement, bool in_mm, Notes& notes);

// Applies `map` to `mesh`, and flips the triangles if it mirrors. Throws Error(bad_input) if a coordinate ends up
// beyond 1e7 mm.
void move(Mesh& mesh, const Affine& map);

// Adds the vertices and triangles of `from` to `to`.
void append(const Mesh& from, Mesh& to);

// Removes vertices without a triangle.  The others keep their order.
void drop_unused_vertices(Mesh& mesh);

// Signed volume, mm3: positive if the triangles face outwards.
double volume(const Mesh& mesh);

// The connected parts of a mesh.  Triangles that share a vertex are connected.
struct Shells {
    std::vector<std::uint32_t> of_vertex; // the vertex's shell; shells are numbered by their first vertices
    std::size_t count = 0;
};
Shells shells_of(const Mesh& mesh);

} // namespace filum::mesh
