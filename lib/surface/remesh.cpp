#include "surface/remesh.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>

namespace filum::surface {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr double kMostTriangles = 2e7;
constexpr double kSharp = 30; // degrees between normals
constexpr unsigned kRounds = 3;

CgalMesh to_cgal(const Surface& s) {
    CgalMesh out;
    out.reserve(static_cast<CgalMesh::size_type>(s.vertices.size()), static_cast<CgalMesh::size_type>(s.twin.size()),
                static_cast<CgalMesh::size_type>(s.triangles.size()));
    using Vertex = CgalMesh::Vertex_index;
    for (const Vec3& p : s.vertices) out.add_vertex({p.x, p.y, p.z});
    for (const auto& [a, b, c] : s.triangles)
        if (out.add_face(Vertex(a), Vertex(b), Vertex(c)) == CgalMesh::null_face())
            throw Error(Exit::failure, "cannot remesh the surface: parts of it touch along an edge that was cut; "
                                       "repair it first");
    return out;
}

mesh::Mesh from_cgal(CgalMesh& m) {
    m.collect_garbage();
    mesh::Mesh out;
    for (const auto v : m.vertices()) out.vertices.push_back({m.point(v).x(), m.point(v).y(), m.point(v).z()});
    for (const auto f : m.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : m.vertices_around_face(m.halfedge(f))) t[k++] = v;
        out.triangles.push_back(t);
    }
    return out;
}

} // namespace

Surface remesh(const Surface& s, double edge, Notes& notes) {
    const double triangles = area(s) / (std::sqrt(3) / 4 * edge * edge);
    if (!(triangles <= kMostTriangles))
        throw Error(Exit::usage, "cannot remesh to sides of " + shortest_text(edge) +
                                     " mm: that takes more than 20 million triangles; raise --remesh");
    try {
        CgalMesh m = to_cgal(s);
        auto kept = m.add_property_map<CgalMesh::Edge_index, bool>("e:kept", false).first;
        pmp::detect_sharp_edges(m, kSharp, kept);
        std::vector<CgalMesh::Edge_index> lines;
        for (const auto e : m.edges())
            if (m.is_border(e)) kept[e] = true;
        for (const auto e : m.edges())
            if (kept[e]) lines.push_back(e);
        pmp::split_long_edges(lines, edge, m, pmp::parameters::edge_is_constrained_map(kept));
        pmp::isotropic_remeshing(
            m.faces(), edge, m,
            pmp::parameters::number_of_iterations(kRounds).edge_is_constrained_map(kept).protect_constraints(true));
        return connect(from_cgal(m), notes);
    } catch (const CGAL::Failure_exception&) {
        throw Error(Exit::failure, "cannot remesh the surface: CGAL found it not fit; try another --remesh");
    }
}

} // namespace filum::surface
