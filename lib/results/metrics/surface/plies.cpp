#include "metrics/surface/plies.hpp"

#include "geodesic/query.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <map>

namespace filum::metrics::surface {

namespace {

constexpr std::size_t kMostTriangles = 1'500'000;

void add(Area& sum, const Area& a) {
    sum.surface += a.surface;
    sum.covered += a.covered;
    sum.unreached += a.unreached;
    sum.strip += a.strip;
    sum.strip_covered += a.strip_covered;
    if (a.void_radius > sum.void_radius) {
        sum.void_radius = a.void_radius;
        sum.void_at = a.void_at;
    }
}

double laid(const Fibres& fibres, std::uint32_t layer) {
    double sum = 0;
    for (const Fibre& c : fibres.all)
        for (std::size_t i = 0; i < c.width.size(); ++i)
            sum += c.layer[i] == layer ? c.width[i] * (c.along[i + 1] - c.along[i]) : 0;
    return sum;
}

// Distances from the path at the vertices of a refinement of the finer surface.
class VertexDistances {
  public:
    VertexDistances(const Ground& ground, double edge)
        : ground_(ground), fine_(finer(ground.finer.surface, edge, kMostTriangles)), in_(fine_.surface.vertices.size()),
          values_(fine_.surface.vertices.size(), 0) {
        for (std::uint32_t t = 0; t < fine_.parent.size(); ++t)
            for (const std::uint32_t v : fine_.surface.triangles[t]) in_[v] = fine_.parent[t];
    }
    void add(const PathField& field, int threads) {
        parallel::for_chunks(in_.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                double least = std::numeric_limits<double>::infinity();
                for (const auto& c : field.classes)
                    least = std::min(least, geodesic::distance_at(ground_.finer.surface, c.field, in_[v],
                                                                  fine_.surface.vertices[v]));
                values_[v] = std::max(values_[v], least);
            }
        });
    }
    filum::surface::Sheet take() {
        return {std::move(fine_.surface), {filum::surface::Field{"path-distance", std::move(values_)}}, {}, {}};
    }

  private:
    const Ground& ground_;
    filum::surface::FinerSurface fine_;
    std::vector<std::uint32_t> in_;
    std::vector<double> values_;
};

} // namespace

Plies measure_plies(const Fibres& fibres, const Ground& ground, std::span<const Sample> samples,
                    const PlyOptions& options, int threads) {
    std::map<std::uint32_t, std::vector<Sample>> layers;
    for (const Sample& s : samples) layers[s.layer].push_back(s);
    Plies out;
    std::optional<VertexDistances> distances;
    if (options.distance) distances.emplace(ground, options.spacing / 4);
    for (const auto& [layer, own] : layers) {
        std::vector<Weighted> off;
        for (const Sample& s : own) off.push_back({s.off, s.length});
        const Shadow below = shadow(fibres, ground, {layer, quantile(off, 0.5), options.spacing / 2}, threads);
        const PathField field = path_field(ground, below);
        const Area area = measure_area(ground, field, options.spacing, threads);
        ++out.count;
        add(out.area, area);
        out.least = std::min(out.least, area.covered / area.surface);
        out.laid += laid(fibres, layer) - below.beside_area;
        out.paper += paper_area_fraction(ground, own, options.spacing, threads);
        out.beside += below.beside;
        out.aloft += below.aloft;
        out.lost += below.lost;
        if (distances) distances->add(field, threads);
    }
    if (distances) out.distance = distances->take();
    return out;
}

} // namespace filum::metrics::surface
