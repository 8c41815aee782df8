#include "metrics/surface/strands.hpp"

#include "parallel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace filum::metrics::surface {

namespace {

constexpr double kNeighbour = 1.5;   // nominal spacings: what is farther is no neighbour
constexpr double kParallel = 0.866;  // cosine of 30 degrees
constexpr double kBetween = 3;       // nominal spacings of fibre between neighbours on one chain
constexpr double kSame = 0.25;       // bead widths
constexpr double kSameWay = 0.96593; // cosine of 15 degrees
constexpr double kSameBetween = 2;   // bead widths
constexpr double kMostCells = 2e6;   // along a side of the box, so that keys fit

// Samples by the cell of a cubic grid that their middles lie in.
class Cells {
  public:
    Cells(std::span<const Sample> samples, double cell) : cell_(cell) {
        constexpr double far = std::numeric_limits<double>::infinity();
        lo_ = {far, far, far};
        Vec3 hi{-far, -far, -far};
        for (const Sample& s : samples) {
            lo_ = {std::min(lo_.x, s.at.x), std::min(lo_.y, s.at.y), std::min(lo_.z, s.at.z)};
            hi = {std::max(hi.x, s.at.x), std::max(hi.y, s.at.y), std::max(hi.z, s.at.z)};
        }
        const Vec3 size = samples.empty() ? Vec3{} : hi - lo_;
        cell_ = std::max(cell_, std::max({size.x, size.y, size.z}) / kMostCells);
        for (std::uint32_t i = 0; i < samples.size(); ++i) {
            const Vec3 r = 1 / cell_ * (samples[i].at - lo_);
            entries_.push_back({key(column(r.x), column(r.y), column(r.z)), i});
        }
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return a.key != b.key ? a.key < b.key : a.sample < b.sample; });
    }

    // Calls f(i) for every sample whose middle is within a cell's size of p, and for others.
    template <class F>
    void near(const Vec3& p, F&& f) const {
        const Vec3 r = 1 / cell_ * (p - lo_);
        const std::int64_t x = column(r.x), y = column(r.y), z = column(r.z);
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j) {
                const std::int64_t first = key(i, j, z - 1), last = key(i, j, z + 1);
                auto it = std::lower_bound(entries_.begin(), entries_.end(), first,
                                           [](const Entry& e, std::int64_t k) { return e.key < k; });
                for (; it != entries_.end() && it->key <= last; ++it) f(it->sample);
            }
    }

  private:
    struct Entry {
        std::int64_t key;
        std::uint32_t sample;
    };
    static std::int64_t column(double v) { return static_cast<std::int64_t>(v) + 1; }
    static std::int64_t key(std::int64_t x, std::int64_t y, std::int64_t z) { return (x << 42) + (y << 21) + z; }
    double cell_;
    Vec3 lo_{};
    std::vector<Entry> entries_;
};

double widest(std::span<const Sample> samples) {
    double out = 0;
    for (const Sample& s : samples) out = std::max(out, s.width);
    return out;
}

// The length of an arc of which the chord and the angle between its ends' normals are known.
double arc(double chord, const Vec3& n, const Vec3& m) {
    const double half = std::atan2(norm(cross(n, m)), dot(n, m)) / 2;
    return half > 1e-6 ? chord * half / std::sin(half) : chord;
}

class Search {
  public:
    Search(std::span<const Sample> samples, const Cells& cells, double spread, bool turns)
        : samples_(samples), cells_(cells), spread_(spread), turns_(turns) {}

    void gaps(std::uint32_t i, std::vector<Gap>& out) const {
        const Sample& s = samples_[i];
        if (left_out(s)) return;
        const Vec3 aside = cross(s.normal, s.tangent);
        double nearest[2] = {kFar, kFar};
        cells_.near(s.at, [&](std::uint32_t k) {
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
        cells_.near(s.at, [&](std::uint32_t k) {
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
    const Cells cells(samples, kNeighbour * spread * widest(samples) * 1.2);
    const Search search(samples, cells, spread, turns);
    std::vector<std::vector<Gap>> parts((samples.size() + kGrain - 1) / kGrain);
    parallel::for_chunks(samples.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) search.gaps(static_cast<std::uint32_t>(i), parts[begin / kGrain]);
    });
    std::vector<Gap> out;
    for (const auto& p : parts) out.insert(out.end(), p.begin(), p.end());
    return out;
}

double retraced(std::span<const Sample> samples, int threads) {
    const Cells cells(samples, widest(samples));
    const Search search(samples, cells, 1, true);
    std::vector<char> found(samples.size(), 0);
    parallel::for_chunks(samples.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) found[i] = search.retraced(static_cast<std::uint32_t>(i)) ? 1 : 0;
    });
    double sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += found[i] != 0 ? samples[i].length : 0;
    return sum;
}

} // namespace filum::metrics::surface
