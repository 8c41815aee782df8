#include "surface/fit/fitter.hpp"

#include "geom/angle.hpp"
#include "parallel/parallel.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <numbers>
#include <queue>

namespace filum::surface::fit {

namespace {

using curve::Place;

constexpr int kRounds = 3;                    // rounds of all four steps; afterwards triangles hardly change
constexpr int kMostFlips = 20;                // sweeps; on curved surfaces flips may cycle
constexpr double kFlat = 1e-9;                // rad: least excess of opposite angles over half a turn for a flip
constexpr std::size_t kVerticesAtOnce = 1024; // vertices per task

} // namespace

void Fitter::run() {
    for (int round = 0; round < kRounds; ++round) {
        collapse_short(); // before long sides of thin triangles are split into many
        split_long();
        collapse_short();
        flip_all();
        move_all();
    }
    flip_all();
}

void Fitter::run_by_halves() {
    double scale = 1;
    for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
        if (!m_.gone(h)) scale = std::max(scale, m_.length(h) / target(m_.tail(h), m_.head(h)));
    // Sides are up to twice as long as the next halving leaves them, and a merged vertex must not make them longer.
    for (; scale > 1; scale /= 2) {
        collapse_short(2 * scale);
        split_long(scale);
    }
    collapse_short(2 * scale);
    run();
}

void Fitter::resize(std::size_t most_splits) {
    most_splits_ = most_splits;
    parallel::for_chunks(m_.at.size(), kVerticesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            if (m_.out[v] != kNone) m_.size[v] = size_at(locator_.nearest(m_.at[v]));
    });
}

double Fitter::size_at(const Place& p) const {
    const auto w = curve::barycentric(from_, p);
    double out = 0;
    for (std::size_t k = 0; k < 3; ++k) out += std::clamp(w[k], 0.0, 1.0) * sizes_[from_.triangles[p.triangle][k]];
    return out;
}

// Splits the side that is longest relative to its size first, so new sides are shorter.
void Fitter::split_long(double scale) {
    std::priority_queue<std::pair<double, std::uint32_t>> open; // lengths in sizes; half-edges
    const auto sizes = [&](std::uint32_t h) { return m_.length(h) / target(m_.tail(h), m_.head(h)); };
    const auto add = [&](std::uint32_t h) {
        if (const double now = sizes(h); now > kLong * scale) open.emplace(now, h);
    };
    for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
        if (!m_.gone(h) && m_.first(h)) add(h);
    for (std::size_t left = most_splits_; !open.empty() && left > 0;) {
        const auto [was, h] = open.top();
        open.pop();
        if (sizes(h) != was) continue; // it has been split since
        const std::uint32_t v = split(m_, h);
        --left;
        ++splits_;
        each_leaving(m_, v, [&](std::uint32_t k) { // sides around it have new numbers
            for (const std::uint32_t side : {k, next(k), prev(k)}) add(side);
        });
    }
}

void Fitter::collapse_short(double scale) {
    const auto most = [&](std::uint32_t a, std::uint32_t b) { return scale * kLong * target(a, b); };
    for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
        if (!m_.gone(h) && m_.length(h) < kShort * target(m_.tail(h), m_.head(h)) && collapsible(m_, h, most))
            collapse(m_, h);
}

// Flips sides by the Delaunay criterion: first checks all sides, then those around flipped ones, and so on.
void Fitter::flip_all() {
    std::vector<std::uint32_t> open, about;
    for (std::uint32_t h = 0; h < m_.twin.size(); ++h)
        if (!m_.gone(h) && m_.first(h)) open.push_back(h);
    for (int sweep = 0; sweep < kMostFlips && !open.empty(); ++sweep) {
        for (const std::uint32_t h : open) {
            const std::uint32_t g = m_.twin[h];
            if (g == kNone || !(opposite(h) > kFlat) || !flippable(m_, h)) continue;
            flip(m_, h);
            for (const std::uint32_t t : {h / 3, g / 3}) about.insert(about.end(), {3 * t, 3 * t + 1, 3 * t + 2});
        }
        open.swap(about);
        about.clear();
    }
}

// Sum of the angles opposite to a side minus half a turn, rad.
double Fitter::opposite(std::uint32_t h) const {
    const auto at = [&](std::uint32_t k) {
        const Vec3 a = m_.at[m_.tail(k)] - m_.at[m_.apex(k)], b = m_.at[m_.head(k)] - m_.at[m_.apex(k)];
        return geom::angle(a, b);
    };
    return at(h) + at(m_.twin[h]) - std::numbers::pi;
}

// Centre of the vertex's fan, in which each triangle is weighted by its area in intended sizes.
Vec3 Fitter::middle(std::uint32_t v) const {
    Vec3 sum;
    double all = 0;
    each_leaving(m_, v, [&](std::uint32_t h) {
        const std::uint32_t a = m_.head(h), b = m_.apex(h);
        const double size = (m_.size[v] + m_.size[a] + m_.size[b]) / 3;
        const double weight = norm(cross(m_.at[a] - m_.at[v], m_.at[b] - m_.at[v])) / (size * size);
        sum = sum + weight / 3 * (m_.at[v] + m_.at[a] + m_.at[b]);
        all += weight;
    });
    return all > 0 ? 1 / all * sum : m_.at[v];
}

// Moves every free vertex to the centre of its current fan, and from there to the surface, where that faces as the
// vertex does.
void Fitter::move_all() {
    std::vector<Place> to(m_.at.size(), Place{kNone, {}});
    parallel::for_chunks(to.size(), kVerticesAtOnce, 0, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
            if (m_.out[v] != kNone && m_.kind[v] == VertexKind::free)
                to[v] = locator_.nearest(middle(v), m_.up[v], m_.size[v]);
    });
    for (std::uint32_t v = 0; v < to.size(); ++v) {
        if (to[v].triangle == kNone || !may_move(m_, v, to[v].point)) continue;
        m_.at[v] = to[v].point;
        m_.up[v] = normal(from_, to[v].triangle);
        m_.size[v] = size_at(to[v]);
    }
}

} // namespace filum::surface::fit
