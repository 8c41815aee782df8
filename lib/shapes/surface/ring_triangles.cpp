#include "surface/ring_triangles.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <set>

namespace filum::surface {

namespace {

using geom::Vec3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

// The ring projected such that it runs counter-clockwise.
std::vector<Point> seen(std::span<const Vec3> ring) {
    Vec3 area;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) area = area + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    const Vec3 up = geom::unit(area, {0, 0, 1});
    const Vec3 side = geom::unit(cross(up, std::abs(up.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}), {1, 0, 0});
    const Vec3 ahead = cross(up, side);
    std::vector<Point> out;
    out.reserve(ring.size());
    for (const Vec3& p : ring) out.emplace_back(dot(p - ring[0], side), dot(p - ring[0], ahead));
    return out;
}

// The faces inside the constrained ring, which runs counter-clockwise: flood fill from those on its left up to
// constraints.
std::set<Triangulation::Face_handle> within(const Triangulation& t,
                                            const std::vector<Triangulation::Vertex_handle>& ring) {
    std::vector<Triangulation::Face_handle> next;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Triangulation::Face_handle face;
        int across = 0; // the corner of the face opposite to the side
        if (!t.is_edge(ring[i], ring[(i + 1) % ring.size()], face, across)) continue;
        const bool left = face->vertex(Triangulation::ccw(across)) == ring[i];
        next.push_back(left ? face : face->neighbor(across));
    }
    std::set<Triangulation::Face_handle> out;
    while (!next.empty()) {
        const auto face = next.back();
        next.pop_back();
        if (!out.insert(face).second) continue;
        for (int k = 0; k < 3; ++k)
            if (!face->is_constrained(k)) next.push_back(face->neighbor(k));
    }
    return out;
}

} // namespace

std::vector<mesh::Triangle> ring_triangles(std::span<const Vec3> ring) {
    const std::vector<Point> points = seen(ring);
    if (points.size() < 3 || !CGAL::is_simple_2(points.begin(), points.end(), Kernel())) return {};
    Triangulation t;
    std::vector<Triangulation::Vertex_handle> vertices;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        vertices.push_back(t.insert(points[i], vertices.empty() ? nullptr : vertices.back()->face()));
        vertices.back()->info() = i;
    }
    for (std::size_t i = 0; i < points.size(); ++i) t.insert_constraint(vertices[i], vertices[(i + 1) % points.size()]);
    const auto inside = within(t, vertices);
    std::vector<mesh::Triangle> out;
    for (const auto face : t.finite_face_handles())
        if (inside.contains(face))
            out.push_back({face->vertex(2)->info(), face->vertex(1)->info(), face->vertex(0)->info()});
    return out;
}

} // namespace filum::surface
