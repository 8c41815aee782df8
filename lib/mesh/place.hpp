// Putting a mesh where it is to be made: unit, size, orientation, position.
#pragma once

#include "base/note.hpp"
#include "geom/affine.hpp"
#include "mesh/mesh.hpp"

#include <string>

namespace filum::mesh {

using geom::Affine;

// Applied in this order.
struct Placement {
    std::string unit = "mm";                 // of the file: um, mm, cm, m, in, or auto: guessed from the size
    std::vector<double> scale{1};            // one factor, or one per axis; negative ones mirror
    std::vector<double> rotate_deg{0, 0, 0}; // about the x axis, then y, then z, all through the origin
    std::vector<double> translate{0, 0, 0};  // mm
    std::vector<double> center{};            // x and y that the middle of the box comes to, mm; empty: leave it
    bool on_bed = true;                      // the lowest point comes to z = 0,
    bool keep_z = false;                     // unless this is set
};

// The map that turns about the x axis, then y, then z, by degrees, and then moves by mm; three numbers each.
Affine rigid(const std::vector<double>& rotate_deg, const std::vector<double>& translate);

using geom::Box3;
Box3 bounds(const Mesh& mesh); // precondition: a vertex

inline constexpr double kMaxCoordinate = 1e7; // mm

struct Placed {
    Affine map;      // from the file's coordinates
    double unit = 1; // mm, that these are in
};

// Moves `mesh` as `placement` says; `in_mm` if the file states its unit itself (then only "auto" and "mm" are allowed).
// A map that mirrors turns the triangles round, so that outside stays outside.  Vertices without a triangle go.
// Returns what did it all.
// Throws Error: usage for options that cannot be obeyed, bad_input if a coordinate ends up beyond 1e7 mm.
Placed place(Mesh& mesh, const Placement& placement, bool in_mm, Notes& notes);

// Moves `mesh` by a map, as place() does.  Throws Error(bad_input) if a coordinate ends up beyond 1e7 mm.
void move(Mesh& mesh, const Affine& map);

// Takes vertices without a triangle out; the others keep their order.
void drop_unused_vertices(Mesh& mesh);

// Signed volume, mm3: positive if the triangles face outwards.
double volume(const Mesh& mesh);

// Which triangles hang together, by shared vertices.
struct Shells {
    std::vector<std::uint32_t> of_vertex; // numbered by their first vertices
    std::size_t count = 0;
};
Shells shells_of(const Mesh& mesh);

} // namespace filum::mesh
