// Exact distances from a vertex beside those of CGAL's Surface_mesh_shortest_path, at every n-th vertex; and the time.
#include "base/error.hpp"
#include "geodesic/exact.hpp"
#include "mesh/read.hpp"
#include "surface/surface.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace {

using namespace filum;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, CgalMesh>>;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

int run(int argc, char** argv) {
    const std::string path = argv[1];
    const auto source = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 0);
    const auto every = static_cast<std::uint32_t>(argc > 3 ? std::atoi(argv[3]) : 20);
    Notes notes;
    const surface::Surface s =
        surface::connect(mesh::read(mesh::load(path).view(), mesh::spoken_name(path)).mesh, notes);
    if (source >= s.vertices.size() || every == 0) return std::fprintf(stderr, "no such vertex\n"), 2;
    const double start = seconds();
    const auto field = geodesic::exact(s, {{source}, {}});
    std::printf("triangles %zu  windows %zu  exact %.3f s CPU\n", s.triangles.size(),
                static_cast<std::size_t>(field.propagated), seconds() - start);
    CgalMesh m;
    using Vertex = CgalMesh::Vertex_index;
    for (const auto& p : s.vertices) m.add_vertex({p.x, p.y, p.z});
    for (const auto& [a, b, c] : s.triangles) m.add_face(Vertex(a), Vertex(b), Vertex(c));
    const double before = seconds();
    ShortestPath truth(m);
    truth.add_source_point(Vertex(source));
    double worst = 0;
    std::size_t compared = 0;
    for (std::uint32_t v = 0; v < s.vertices.size(); v += every) {
        if (!std::isfinite(field.distance[v])) continue;
        worst =
            std::max(worst, std::abs(truth.shortest_distance_to_source_points(Vertex(v)).first - field.distance[v]));
        ++compared;
    }
    std::printf("CGAL %.3f s CPU  compared %zu  largest difference %.3g mm\n", seconds() - before, compared, worst);
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) return std::fprintf(stderr, "bench_geodesic MESH [VERTEX [EVERY]]\n"), 2;
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        return std::fprintf(stderr, "bench_geodesic: %s\n", e.what()), 1;
    }
}
