#include "metrics/surface/neighbours.hpp"

#include "geom/point_grid.hpp"
#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace filum::metrics::surface {

namespace {

constexpr double kNeighbour = 1.5;   // nominal spacings: greatest distance of neighbours
constexpr double kParallel = 0.866;  // cosine of 30 degrees
constexpr double kBetween = 3;       // nominal spacings of fibre between neighbours on one chain
constexpr double kSame = 0.25;       // bead widths
constexpr double kSameWay = 0.96593; // cosine of 15 degrees
constexpr double kSameBetween = 2;   // bead widths

// The samples by the places of their middles.
using Cells = geom::PointGrid<Vec3>;

Cells cells_of(std::span<const Sample> samples, double size) {
    std::vector<Vec3> at;
    at.reserve(samples.size());
    for (const Sample& s : samples) at.push_back(s.at);
    return Cells(at, size);
}

double widest(std::span<const Sample> samples) {
    double out = 0;
    for (const Sample& s : samples) out = std::max(out, s.width);
    return out;
}

// The length of an arc from its chord and the angle between the normals at its ends.
double arc(double chord, const Vec3& n, const Vec3& m) {
    const double half = angle(n, m) / 2;
    return half > 1e-6 ? chord * half / std::sin(half) : chord;
}

class GapSearch {
  public:
    GapSearch(std::span<const Sample> samples, const Cells& cells, double spread, bool turns)
        : samples_(samples), cells_(cells), spread_(spread), turns_(turns) {}

    void gaps(std::uint32_t i, std::vector<Gap>& out) const {
        const Sample& s = samples_[i];
        if (left_out(s)) return;
        const Vec3 aside = cross(s.normal, s.tangent);
        double nearest[2] = {kFar, kFar};
        cells_.near(s.at, 1, [&](std::uint32_t k) {
            const Sample& o = samples_[k];
            if (o.layer != s.layer || left_out(o)) return;
            const double nominal = (s.width + o.width) / 2 * spread_;
            if (dot(s.normal, o.normal) <= 0 || std::abs(dot(s.tangent, o.tangent)) < kParallel) return;
            if (o.chain == s.chain && std::abs(o.along - s.along) < kBetween * nominal) return;
            const double before = dot(o.a - s.at, s.tangent), after = dot(o.b - s.at, s.tangent);
            if ((before < 0) == (after < 0)) return;
            const Vec3 way = o.a + before / (before - after) * (o.b - o.a) - s.at;
            const double spacing = arc(norm(way), s.normal, o.normal) / nominal;
            double& best = nearest[dot(way, aside) > 0 ? 1 : 0];
            if (spacing <= kNeighbour) best = std::min(best, spacing);
        });
        for (const double v : nearest)
            if (v < kFar) out.push_back({v - 1, s.length});
    }

    [[nodiscard]] bool retraced(std::uint32_t i) const {
        const Sample& s = samples_[i];
        bool found = false;
        cells_.near(s.at, 1, [&](std::uint32_t k) {
            const Sample& o = samples_[k];
            if (found || k >= i || o.layer != s.layer) return;
            if (dot(s.normal, o.normal) <= 0 || std::abs(dot(s.tangent, o.tangent)) < kSameWay) return;
            if (o.chain == s.chain && std::abs(o.along - s.along) < kSameBetween * s.width) return;
            const Vec3 d = o.b - o.a;
            const double t = std::clamp(dot(s.at - o.a, d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
            found = distance(s.at, o.a + t * d) <= kSame * s.width;
        });
        return found;
    }

  private:
    [[nodiscard]] bool left_out(const Sample& s) const { return s.hairpin || (s.turning && !turns_); }

    static constexpr double kFar = std::numeric_limits<double>::infinity();
    std::span<const Sample> samples_;
    const Cells& cells_;
    double spread_;
    bool turns_;
};

} // namespace

std::vector<Gap> gaps(std::span<const Sample> samples, double spread, bool turns, int threads) {
    const Cells cells = cells_of(samples, kNeighbour * spread * widest(samples) * 1.2);
    const GapSearch search(samples, cells, spread, turns);
    std::vector<std::vector<Gap>> parts((samples.size() + kGrain - 1) / kGrain);
    parallel::for_chunks(samples.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) search.gaps(static_cast<std::uint32_t>(i), parts[begin / kGrain]);
    });
    std::vector<Gap> out;
    for (const auto& p : parts) out.insert(out.end(), p.begin(), p.end());
    return out;
}

double retraced(std::span<const Sample> samples, int threads) {
    const Cells cells = cells_of(samples, widest(samples));
    const GapSearch search(samples, cells, 1, true);
    std::vector<char> found(samples.size(), 0);
    parallel::for_chunks(samples.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) found[i] = search.retraced(static_cast<std::uint32_t>(i)) ? 1 : 0;
    });
    double sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += found[i] != 0 ? samples[i].length : 0;
    return sum;
}

} // namespace filum::metrics::surface
