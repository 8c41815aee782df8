// A triangulated surface, open or closed: triangles and who meets whom along their edges, as flat arrays.
#pragma once

#include "base/error.hpp"
#include "base/fact.hpp"
#include "base/note.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surface {

using geom::Vec3;
using mesh::Triangle;

inline constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Half-edge 3 t + k leads from corner k of triangle t to the next one; the triangle lies to its left, seen from the
// side that it faces.
constexpr std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

// A closed rim of the surface; the surface lies to its left.
struct Rim {
    std::vector<std::uint32_t> sides; // half-edges, each beginning where the one before ends; begins with the least
    std::uint32_t component = 0;
    bool outer = false; // the rim of its component that spans the greatest area (the first of equals)
};

// Every edge has one or two triangles, every vertex one fan of triangles: the surface is a manifold, and all of a
// component faces one way.  Every triangle has an area.
struct Surface {
    std::vector<Vec3> vertices; // mm; each is a corner of some triangle
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> twin;      // per half-edge: the one the other way, kNone at a rim
    std::vector<std::uint32_t> outgoing;  // per vertex: a half-edge that leaves it; the rim's, if it is on one
    std::vector<std::uint32_t> component; // per triangle: numbered by their first triangles
    std::uint32_t components = 0;
    std::vector<Rim> rims; // by their first half-edges

    [[nodiscard]] std::uint32_t tail(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    [[nodiscard]] std::uint32_t head(std::uint32_t h) const { return tail(next(h)); }
    [[nodiscard]] bool on_rim(std::uint32_t vertex) const { return twin[outgoing[vertex]] == kNone; }
};

// Calls visit(h) for half-edge `first` and those that leave the same vertex after it, counter-clockwise; twin: of each.
// The walk ends because half-edges are joined in pairs; if they are not, it throws Error(failure) after as many steps
// as there are half-edges.
template <class Visit>
void each_of_fan(const std::vector<std::uint32_t>& twin, std::uint32_t first, const Visit& visit) {
    std::uint32_t h = first;
    for (std::size_t step = 0; step < twin.size(); ++step) {
        visit(h);
        h = twin[prev(h)];
        if (h == kNone || h == first) return;
    }
    throw Error(Exit::failure, "internal error: a fan of triangles does not close");
}

// The same for every half-edge that leaves `vertex`; h / 3 are the triangles of its fan.
template <class Visit>
void each_outgoing(const Surface& s, std::uint32_t vertex, const Visit& visit) {
    each_of_fan(s.twin, s.outgoing[vertex], visit);
}

// The surface of `mesh`, whose vertices are welded (mesh::read).  Repairs, each with a note that counts: triangles that
// stand twice go; triangles without area go, the neighbour on the longest side taking over the third corner; triangles
// that face against their neighbours are turned round; where more than two meet along an edge, the two that continue
// each other flattest stay joined and the others are cut off; fans that touch in a point only are cut apart; a surface
// with one side only is cut open.
// If `faces` is given, it gets the CAD face of each triangle, those of mesh.faces; `of_file` gets mesh.of_file, now for
// the surface's vertices.
// Throws Error(bad_input) if no triangle remains.
Surface connect(mesh::Mesh mesh, Notes& notes, std::vector<std::uint32_t>* faces = nullptr,
                std::vector<std::uint32_t>* of_file = nullptr);

// The surface of these parts: finds outgoing half-edges, components and rims.  Throws Error(bad_input) if the parts
// break a promise of Surface (but for areas): "an index is out of range", "sides are joined that are not the same
// edge".
Surface assemble(std::vector<Vec3> vertices, std::vector<Triangle> triangles, std::vector<std::uint32_t> twin);

// The surface with more triangles, behind its own, on `vertices`, of which its own come first. Their sides are joined
// to each other and to its rims where they run the other way between the same vertices.
Surface grown(const Surface& s, std::vector<Vec3> vertices, const std::vector<Triangle>& more);

// Its size as facts: "vertices", "triangles", "components", "rims", "area".
Facts facts(const Surface& s);

double area(const Surface& s);                         // mm2
double area(const Surface& s, std::uint32_t triangle); // mm2
inline double side_length(const Surface& s, std::uint32_t h) {
    return geom::distance(s.vertices[s.tail(h)], s.vertices[s.head(h)]); // mm
}
double rim_length(const Surface& s, const Rim& rim);   // mm
double mean_edge(const Surface& s);                    // mm, over half-edges
double longest_edge(const Surface& s);                 // mm
Vec3 normal(const Surface& s, std::uint32_t triangle); // unit

} // namespace filum::surface
