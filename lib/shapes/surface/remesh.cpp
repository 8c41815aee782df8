#include "surface/remesh.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/clip.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace filum::surface {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

constexpr double kMostTriangles = 2e7;
constexpr double kSharp = 30; // degrees between normals
constexpr unsigned kRemeshingRounds = 3;

// Per half-edge whether it is on a rim and another edge connects the same two vertices, as where one of more than two
// triangles was cut off. CGAL's meshes have at most one edge between two vertices.
std::vector<char> doubled_rims(const Surface& s) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> edges; // ends, ascending; its half-edge
    const auto n = static_cast<std::uint32_t>(s.twin.size());
    for (std::uint32_t h = 0; h < n; ++h) {
        const std::uint32_t a = s.triangles[h / 3][h % 3], b = s.triangles[h / 3][(h + 1) % 3];
        if (s.twin[h] == kNone || h < s.twin[h]) edges.emplace_back(std::min(a, b), std::max(a, b), h);
    }
    std::sort(edges.begin(), edges.end());
    std::vector<char> out(n, 0);
    const auto same = [&](std::size_t i, std::size_t j) {
        return j < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[j]) &&
               std::get<1>(edges[i]) == std::get<1>(edges[j]);
    };
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (const std::uint32_t h = std::get<2>(edges[i]); s.twin[h] == kNone)
            out[h] = same(i, i + 1) || (i > 0 && same(i, i - 1)) ? 1 : 0;
    return out;
}

// Converts the surface; a doubled edge of a rim gets a vertex in its middle.
CgalMesh to_cgal(const Surface& s) {
    CgalMesh out;
    out.reserve(static_cast<CgalMesh::size_type>(s.vertices.size()), static_cast<CgalMesh::size_type>(s.twin.size()),
                static_cast<CgalMesh::size_type>(s.triangles.size()));
    using Vertex = CgalMesh::Vertex_index;
    for (const Vec3& p : s.vertices) out.add_vertex({p.x, p.y, p.z});
    const auto doubled = doubled_rims(s);
    for (std::size_t t = 0; t < s.triangles.size(); ++t) {
        std::vector<Vertex> around;
        // corner from which the face is split into a fan: not on a side with an inserted vertex, except its own
        std::size_t apex = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = s.triangles[t][k], b = s.triangles[t][(k + 1) % 3];
            around.emplace_back(a);
            if (doubled[3 * t + k] == 0) continue;
            const Vec3 m = 0.5 * (s.vertices[a] + s.vertices[b]);
            apex = around.size();
            around.push_back(out.add_vertex({m.x, m.y, m.z}));
        }
        std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(apex), around.end());
        for (std::size_t k = 1; k + 1 < around.size(); ++k) out.add_face(around[0], around[k], around[k + 1]);
    }
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

// The mesh as a solid with triangles facing outwards, or inwards if the outer part is to be kept.
CgalMesh closed(mesh::Mesh solid, bool inside) {
    Notes own;
    const Surface s = connect(std::move(solid), own);
    if (!s.rims.empty())
        throw Error(Exit::bad_input, "cannot use --cut-mesh: it is open (" + std::to_string(s.rims.size()) +
                                         " rims), so it has no inside; close its holes first");
    CgalMesh m = to_cgal(s);
    if (pmp::does_self_intersect(m))
        throw Error(Exit::bad_input, "cannot use --cut-mesh: it crosses itself; repair it first");
    pmp::orient_to_bound_a_volume(m);
    if (!inside) pmp::reverse_face_orientations(m);
    return m;
}

} // namespace

std::size_t stretched(const Surface& s, double edge) {
    double work = 0, squarish = 0;
    std::size_t out = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const double longest = std::max({side_length(s, 3 * t), side_length(s, 3 * t + 1), side_length(s, 3 * t + 2)});
        if (longest <= edge) continue;
        const double own = area(s, t) / (std::sqrt(3) / 4);
        work += longest * longest;
        squarish += own;
        out += longest * longest > kMostWork * own ? 1 : 0;
    }
    return work > kMostWork * squarish ? out : 0;
}

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
        pmp::isotropic_remeshing(m.faces(), edge, m,
                                 pmp::parameters::number_of_iterations(kRemeshingRounds)
                                     .edge_is_constrained_map(kept)
                                     .protect_constraints(true));
        return connect(from_cgal(m), notes);
    } catch (const CGAL::Failure_exception&) {
        throw Error(Exit::failure, "cannot remesh the surface: CGAL failed; try another --remesh");
    }
}

Surface cut(const Surface& s, const mesh::Mesh& solid, bool inside, Notes& notes) {
    try {
        CgalMesh m = to_cgal(s), by = closed(solid, inside);
        if (!pmp::clip(m, by, pmp::parameters::clip_volume(false).throw_on_self_intersection(true)))
            throw Error(Exit::failure,
                        "cannot use --cut-mesh: the result would not be a manifold; move the mesh a little");
        mesh::Mesh out = from_cgal(m);
        if (out.triangles.empty())
            throw Error(Exit::usage, std::string("cannot use --cut-mesh: nothing of the surface lies ") +
                                         (inside ? "inside" : "outside"));
        return connect(std::move(out), notes);
    } catch (const pmp::Corefinement::Self_intersection_exception&) {
        throw Error(Exit::bad_input, "cannot use --cut-mesh: the surface crosses itself where it is cut");
    } catch (const CGAL::Failure_exception&) {
        throw Error(Exit::failure, "cannot use --cut-mesh: CGAL failed; repair the meshes, or move one a "
                                   "little");
    }
}

} // namespace filum::surface
