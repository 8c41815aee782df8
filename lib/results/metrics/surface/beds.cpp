#include "geom/bvh.hpp"
#include "metrics/surface/ground.hpp"
#include "metrics/surface/map.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/raise.hpp"

#include <algorithm>
#include <map>

namespace filum::metrics::surface {

namespace {

constexpr double kSampled = 0.5; // of the least width: distance of samples, so that one is near every vertex in a bead
constexpr double kFarthest = 20; // widths: samples farther from a vertex do not determine the level there

// The distance of the nearest sample from the base at each vertex of the base, mm; the median if none is near.
std::vector<double> levels(const Surface& base, const std::vector<Sample>& own, int threads) {
    std::vector<Weighted> off;
    std::vector<geom::Box3> boxes;
    for (const Sample& s : own) {
        off.push_back({s.off, s.length});
        boxes.push_back({s.foot.point, s.foot.point});
    }
    const double reach = kFarthest * own.front().width;
    const geom::Bvh tree(boxes);
    const auto normals = filum::surface::curve::vertex_normals(base);
    std::vector<double> out(base.vertices.size(), quantile(off, 0.5));
    parallel::for_chunks(out.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            double least = reach;
            tree.near(base.vertices[v], reach, [&](std::uint32_t i) {
                const double d = distance(own[i].foot.point, base.vertices[v]);
                if (d < least && dot(own[i].normal, normals[v]) > 0) {
                    least = d;
                    out[v] = own[i].off;
                }
                return least;
            });
        }
    });
    return out;
}

} // namespace

std::vector<Bed> beds(const Surface& base, const Fibres& fibres, int threads) {
    double narrowest = std::numeric_limits<double>::infinity();
    for (const Fibre& c : fibres.all)
        for (const double w : c.width) narrowest = std::min(narrowest, w);
    if (fibres.all.empty()) return {};
    const Ground ground(base, filum::surface::longest_edge(base));
    std::map<std::uint32_t, std::vector<Sample>> layers;
    for (const Sample& s : samples(fibres, ground, kSampled * narrowest, threads))
        if (!s.beside) layers[s.layer].push_back(s);
    std::vector<Bed> out;
    for (const auto& [layer, own] : layers) {
        double faces = 0; // mm of the ply that face as the base does, minus those that face the other way
        for (const Sample& s : own) faces += (dot(s.axis, s.normal) < 0 ? -1 : 1) * s.length;
        const Surface side = faces < 0 ? filum::surface::curve::turned_over(base) : base;
        out.push_back({layer, filum::surface::curve::raised(side, levels(base, own, threads)).surface});
    }
    return out;
}

} // namespace filum::metrics::surface
