// A triangulated surface, open or closed: a half-edge structure in flat arrays.
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

// Half-edge 3 t + k leads from corner k of triangle t to the next corner; the triangle is on its left, seen from the
// side that it faces.
constexpr std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::uint32_t prev(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

// A boundary loop of the surface; the surface is on its left.
struct Rim {
    // half-edges, each beginning where the one before ends, starting with the one of lowest number
    std::vector<std::uint32_t> sides;
    std::uint32_t component = 0;
    bool outer = false; // whether it encloses the greatest area of the rims of its component (ties: the first)
};

// An oriented manifold: every edge has one or two triangles, every vertex one fan, and each component faces one way.
// Every triangle has an area.
struct Surface {
    std::vector<Vec3> vertices; // mm; each is a corner of some triangle
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> twin;      // per half-edge: the one in the opposite direction, kNone at a rim
    std::vector<std::uint32_t> outgoing;  // per vertex: a half-edge that leaves it; at a rim the one on the rim
    std::vector<std::uint32_t> component; // per triangle: components are numbered by their first triangles
    std::uint32_t components = 0;
    std::vector<Rim> rims; // by their first half-edges

    [[nodiscard]] std::uint32_t tail(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    [[nodiscard]] std::uint32_t head(std::uint32_t h) const { return tail(next(h)); }
    [[nodiscard]] bool on_rim(std::uint32_t vertex) const { return twin[outgoing[vertex]] == kNone; }
};

// Calls visit(h) for half-edge `first` and the half-edges that leave the same vertex after it, counter-clockwise.
// `twin` is per half-edge.
// Throws Error(failure) after as many steps as there are half-edges, which can only happen if half-edges are not
// joined in pairs.
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

// Calls visit(h) for every half-edge that leaves `vertex`; h / 3 are the triangles of its fan.
template <class Visit>
void each_outgoing(const Surface& s, std::uint32_t vertex, const Visit& visit) {
    each_of_fan(s.twin, s.outgoing[vertex], visit);
}

// The surface of `mesh`, whose vertices must be merged (mesh::read). Repairs it, each kind with a note that counts:
// - removes repeated triangles, and triangles without area (the neighbour on the longest side gets the third corner);
// - reverses triangles that face against their neighbours;
// - where more than two triangles meet at an edge, keeps the two joined that continue each other best and cuts the
//   others off;
// - separates fans that touch in one point, and cuts one-sided surfaces open.
// `faces` is set to the CAD face of each triangle, from mesh.faces; `of_file` to mesh.of_file for the surface's
// vertices.
// Throws Error(bad_input) if no triangle remains.
Surface connect(mesh::Mesh mesh, Notes& notes, std::vector<std::uint32_t>* faces = nullptr,
                std::vector<std::uint32_t>* of_file = nullptr);

// Assembles a surface from its parts: computes outgoing half-edges, components and rims. Throws Error(bad_input) if
// the parts violate an invariant of Surface (except areas), as "joined half-edges do not belong to the same edge".
Surface assemble(std::vector<Vec3> vertices, std::vector<Triangle> triangles, std::vector<std::uint32_t> twin);

// Adds triangles behind those of the surface. `vertices` begins with the surface's own. Sides of the new triangles are
// joined to each other and to rims of the surface where they connect the same vertices in opposite directions.
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
