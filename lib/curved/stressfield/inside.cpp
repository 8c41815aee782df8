#include "parallel/parallel.hpp"
#include "stressfield/elements.hpp"
#include "stressfield/stencil.hpp"

namespace filum::stressfield {

namespace {

constexpr double kEdge = 1e-9; // fraction of a tetrahedron: tolerance of being inside

using Weights = std::vector<std::pair<std::uint32_t, double>>; // of samples

void add_weight(Weights& out, std::uint32_t sample, double weight) {
    for (auto& [other, sum] : out)
        if (other == sample) {
            sum += weight;
            return;
        }
    out.emplace_back(sample, weight);
}

// Solid elements near a surface.
class SolidElements {
  public:
    SolidElements(const Samples& samples, const Surface& s) : samples_(samples), tree_(choose(s)) {}

    // The weights of nodes at `p`; nothing if no element contains it. Ties: the first element.
    Weights at(const Vec3& p) const {
        std::uint32_t best = ~std::uint32_t{0};
        Weights out;
        tree_.near(p, 0, [&](std::uint32_t k) {
            if (k < best)
                if (Weights w = within(samples_.elements[chosen_[k]], p); !w.empty()) {
                    best = k;
                    out = std::move(w);
                }
            return 0.0;
        });
        return out;
    }

  private:
    std::vector<Box3> choose(const Surface& s) {
        const Box3 near = geom::box_of(s.vertices);
        std::vector<Box3> out;
        for (std::uint32_t e = 0; e < samples_.elements.size(); ++e) {
            const Element& element = samples_.elements[e];
            if (!is_solid(element.shape)) continue;
            Box3 box;
            for (const auto i : nodes_of(samples_, element)) box.add(samples_.points[i]);
            if (meet(box, near)) {
                chosen_.push_back(e);
                out.push_back(box);
            }
        }
        return out;
    }

    Weights within(const Element& element, const Vec3& p) const {
        std::vector<Triangle> triangles;
        std::vector<double> middle;
        triangles_of(samples_, element, triangles);
        middle_weights(element.shape, middle);
        const auto nodes = nodes_of(samples_, element);
        Vec3 m;
        for (std::size_t k = 0; k < nodes.size(); ++k) m = m + middle[k] * samples_.points[nodes[k]];
        for (const auto& t : triangles) {
            const Vec3 a = samples_.points[t[0]] - m, b = samples_.points[t[1]] - m, c = samples_.points[t[2]] - m;
            const Vec3 q = p - m;
            const double volume = dot(a, cross(b, c));
            const double wa = dot(q, cross(b, c)) / volume, wb = dot(a, cross(q, c)) / volume;
            const double wc = dot(a, cross(b, q)) / volume, wm = 1 - wa - wb - wc;
            if (!(std::min({wa, wb, wc, wm}) >= -kEdge)) continue; // or flat: not a number
            Weights out{{t[0], wa}, {t[1], wb}, {t[2], wc}};
            for (std::size_t k = 0; k < nodes.size(); ++k) add_weight(out, nodes[k], wm * middle[k]);
            return out;
        }
        return {};
    }

    const Samples& samples_;
    std::vector<std::uint32_t> chosen_;
    geom::Bvh tree_;
};

class OuterFaces {
  public:
    OuterFaces(const Samples& samples, const Surface& s, const std::vector<Vec3>& normals, int threads)
        : samples_(samples), skin_(skin(samples)), tree_(samples.points, skin_.triangles) {
        // The surface may be inside out: its majority of vertices decides.
        std::vector<double> with(s.vertices.size(), 0);
        parallel::for_chunks(with.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const TriangleHit hit = tree_.nearest(s.vertices[v], kInfinity, [](std::uint32_t) { return true; });
                if (hit.triangle == surface::kNone || skin_.shell[hit.triangle]) continue;
                const Vec3 n = normal(hit.triangle);
                if (norm(n) > 0) with[v] = dot(n, normals[v]) / norm(n);
            }
        });
        double sum = 0;
        for (const double w : with) sum += w;
        facing_ = sum < 0 ? -1 : 1;
    }

    [[nodiscard]] TriangleHit nearest(const Vec3& p, const Vec3& n) const {
        return tree_.nearest(p, kInfinity,
                             [&](std::uint32_t t) { return skin_.shell[t] || facing_ * dot(normal(t), n) > 0; });
    }
    [[nodiscard]] const Triangle& triangle(const TriangleHit& hit) const { return skin_.triangles[hit.triangle]; }
    [[nodiscard]] double mean_side(const TriangleHit& hit) const {
        const auto& [a, b, c] = triangle(hit);
        const auto& p = samples_.points;
        return (distance(p[a], p[b]) + distance(p[b], p[c]) + distance(p[c], p[a])) / 3;
    }

  private:
    [[nodiscard]] Vec3 normal(std::uint32_t t) const {
        const auto& [a, b, c] = skin_.triangles[t];
        const auto& p = samples_.points;
        return cross(p[b] - p[a], p[c] - p[a]);
    }

    const Samples& samples_;
    Skin skin_;
    TriangleTree tree_;
    double facing_ = 1;
};

} // namespace

Stencils in_mesh(const Surface& s, const Samples& samples, double reach, int threads) {
    const auto normal = normals(s);
    const SolidElements solids(samples, s);
    const OuterFaces outside(samples, s, normal, threads);
    const std::size_t n = s.vertices.size();
    std::vector<Weights> found(n);
    Stencils out;
    out.gap.assign(n, kInfinity);
    parallel::for_chunks(n, kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            found[v] = solids.at(s.vertices[v]);
            if (!found[v].empty()) {
                out.gap[v] = 0;
                continue;
            }
            const TriangleHit hit = outside.nearest(s.vertices[v], normal[v]);
            out.gap[v] = hit.distance;
            if (hit.triangle == surface::kNone || hit.distance > (reach > 0 ? reach : outside.mean_side(hit) / 2))
                continue;
            for (std::size_t k = 0; k < 3; ++k) add_weight(found[v], outside.triangle(hit)[k], hit.weights[k]);
        }
    });
    for (const auto& weights : found) {
        out.start.push_back(static_cast<std::uint32_t>(out.sample.size()));
        for (const auto& [sample, weight] : weights) {
            out.sample.push_back(sample);
            out.weight.push_back(weight);
        }
    }
    out.start.push_back(static_cast<std::uint32_t>(out.sample.size()));
    return out;
}

} // namespace filum::stressfield
