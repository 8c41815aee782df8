// Booleans of outlines by several engines, on what `skins` gives to them: a table of CPU seconds, and the greatest
// difference of areas from Clipper's.
//   bench_booleans PART.regions [LAYERS]
// For each pair of consecutive layers, evenly chosen: the intersection of both; and what their outlines wind around
// counter-clockwise once they are moved by 0.8 mm inwards and by 0.8 mm outwards (the union of an offset).
#include "polygon/arrange.hpp"
#include "polygon/clip.hpp"
#include "polygon/moved_outlines.hpp"
#include "stream/frame.hpp"
#include "stream/reader.hpp"
#include "wire/planar.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <boost/polygon/polygon.hpp>
#include <polyclipping/clipper.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <optional>

namespace {

using namespace filum;
using geom::Vec2;
using polygon::Loops;

constexpr double kMoved = 0.8;          // mm: two walls
constexpr double kPerMm = 1e4;          // the grid of Booleans
constexpr std::size_t kCgalLayers = 12; // CGAL is measured on fewer pairs

struct Input {
    Loops a, b; // b is empty for a union of a
};

long long whole(double v) { return std::llround(v * kPerMm); }

// mm2 by Clipper 1. It holds what the outlines wind around at least once, counter-clockwise.
double by_clipper(const Input& in) {
    namespace cl = ClipperLib;
    const auto paths = [](const Loops& a) {
        cl::Paths out(a.size());
        for (std::size_t l = 0; l < a.size(); ++l)
            for (const Vec2 p : a[l]) out[l].emplace_back(whole(p.x), whole(p.y));
        return out;
    };
    cl::Clipper clipper;
    clipper.AddPaths(paths(in.a), cl::ptSubject, true);
    if (!in.b.empty()) clipper.AddPaths(paths(in.b), cl::ptClip, true);
    cl::Paths out;
    clipper.Execute(in.b.empty() ? cl::ctUnion : cl::ctIntersection, out, cl::pftPositive, cl::pftPositive);
    double area = 0;
    for (const auto& path : out) area += cl::Area(path);
    return area / (kPerMm * kPerMm);
}

// The same by the arrangement on the grid (polygon/arrange).
double by_arrangement(const Input& in) {
    std::vector<polygon::Wall> walls = polygon::walls(in.a);
    for (const polygon::Wall& w : polygon::walls(in.b)) walls.push_back(w);
    const auto plane = polygon::arrange(walls);
    const int least = in.b.empty() ? 1 : 2; // times that the outlines wind around a face
    return polygon::signed_area(
        polygon::outline(*plane, [&](std::uint32_t face) { return plane->winding[face] >= least; }));
}

// The same by Boost.Polygon, whose coordinates have 32 bits.
double by_boost(const Input& in) {
    namespace bp = boost::polygon;
    const auto set = [](const Loops& a) {
        bp::polygon_set_data<int> out;
        std::vector<bp::point_data<int>> ring;
        for (std::size_t l = 0; l < a.size(); ++l) {
            ring.clear();
            for (const Vec2 p : a[l]) ring.emplace_back(static_cast<int>(whole(p.x)), static_cast<int>(whole(p.y)));
            out.insert_vertex_sequence(ring.begin(), ring.end(), bp::COUNTERCLOCKWISE, false);
        }
        return out;
    };
    std::vector<bp::polygon_with_holes_data<int>> out;
    const auto a = set(in.a);
    if (in.b.empty()) {
        a.get(out);
    } else {
        using namespace bp::operators;
        bp::polygon_set_data<int> both(a & set(in.b));
        both.get(out);
    }
    double area = 0;
    for (const auto& p : out) area += static_cast<double>(bp::area(p));
    return area / (kPerMm * kPerMm);
}

// The intersection by CGAL; nothing for unions, because CGAL's polygons must not cross themselves.
std::optional<double> by_cgal(const Input& in) {
    using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
    using Polygon = CGAL::Polygon_2<Kernel>;
    using Holed = CGAL::Polygon_with_holes_2<Kernel>;
    using Set = CGAL::Polygon_set_2<Kernel>;
    if (in.b.empty()) return std::nullopt;
    const auto set = [](const Loops& a) {
        Set out;
        for (const Loops& part : polygon::split(a).part) {
            std::vector<Polygon> ring(part.size());
            for (std::size_t l = 0; l < part.size(); ++l)
                for (const Vec2 p : part[l])
                    ring[l].push_back({static_cast<double>(whole(p.x)), static_cast<double>(whole(p.y))});
            out.insert(Holed(ring[0], ring.begin() + 1, ring.end()));
        }
        return out;
    };
    Set a = set(in.a);
    a.intersection(set(in.b));
    std::vector<Holed> out;
    a.polygons_with_holes(std::back_inserter(out));
    double area = 0;
    for (const Holed& p : out) {
        area += CGAL::to_double(p.outer_boundary().area());
        for (const auto& hole : p.holes()) area += CGAL::to_double(hole.area());
    }
    return area / (kPerMm * kPerMm);
}

// All outlines of each layer.
std::vector<Loops> layers_of(const char* path) {
    std::map<std::uint32_t, Loops> layers;
    stream::Reader reader(path, stream::Payload::regions);
    while (const auto frame = reader.next()) {
        if (stream::is_remark(frame->tag)) continue;
        const polygon::Region r = wire::region(*frame);
        Loops& to = layers[r.layer];
        for (std::size_t l = 0; l < r.loops.size(); ++l) to.add(r.loops[l]);
    }
    std::vector<Loops> out;
    for (auto& [index, loops] : layers) out.push_back(std::move(loops));
    return out;
}

struct Row {
    double seconds = 0, off = 0; // off: mm2
    std::size_t count = 0;
};

template <class Engine>
Row measure(const std::vector<Input>& inputs, const std::vector<double>& areas, std::size_t step, Engine&& engine) {
    Row out;
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < inputs.size(); i += step) {
        const std::optional<double> area = engine(inputs[i]);
        if (!area) return out;
        ++out.count;
        if (!areas.empty()) out.off = std::max(out.off, std::abs(*area - areas[i]));
    }
    out.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return out;
}

void table(const char* name, const std::vector<Input>& inputs) {
    std::vector<double> areas;
    std::size_t points = 0;
    for (const Input& in : inputs) points += in.a.points.size() + in.b.points.size();
    const Row first = measure(inputs, {}, 1, [&](const Input& in) {
        areas.push_back(by_clipper(in));
        return std::optional(areas.back());
    });
    std::printf("%s: %zu inputs, %.0f points each\n", name, inputs.size(),
                static_cast<double>(points) / static_cast<double>(inputs.size()));
    const auto print = [&](const char* engine, const Row& row) {
        if (row.count == 0) return;
        const double each = row.seconds / static_cast<double>(row.count);
        std::printf("  %-14s %9.3f ms each %7.2f x   %.4f mm2 off\n", engine, 1e3 * each,
                    each / (first.seconds / static_cast<double>(first.count)), row.off);
    };
    print("Clipper 1", first);
    print("arrangement", measure(inputs, areas, 1, [](const Input& in) { return std::optional(by_arrangement(in)); }));
    print("Boost.Polygon", measure(inputs, areas, 1, [](const Input& in) { return std::optional(by_boost(in)); }));
    print("CGAL", measure(inputs, areas, std::max<std::size_t>(1, inputs.size() / kCgalLayers), by_cgal));
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_booleans PART.regions [LAYERS]\n");
        return 2;
    }
    try {
        const std::vector<Loops> layers = layers_of(argv[1]);
        const std::size_t wanted = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 200;
        const std::size_t step = std::max<std::size_t>(1, layers.size() / std::max<std::size_t>(1, wanted));
        std::vector<Input> both, in, out;
        for (std::size_t i = 0; i + 1 < layers.size(); i += step) {
            both.push_back({layers[i], layers[i + 1]});
            in.push_back({polygon::moved_outlines(layers[i], -kMoved, 0.01), {}});
            out.push_back({polygon::moved_outlines(layers[i], kMoved, 0.01), {}});
        }
        table("intersection of two layers", both);
        table("offset inwards", in);
        table("offset outwards", out);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_booleans: %s\n", e.what());
        return 1;
    }
    return 0;
}
