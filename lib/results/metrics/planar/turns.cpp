#include "metrics/planar/turns.hpp"

#include "geom/polyline.hpp"
#include "parallel/parallel.hpp"
#include "toolpath/radius.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace filum::metrics::planar {

namespace {

constexpr double kSharp = 0.3;           // fraction of the disc
constexpr std::size_t kMostSteps = 4096; // vertices examined on either side of a sample

// Runs of beads and jogs without a stop, within a layer.
std::vector<std::vector<Vec2>> chains(const LayerBeads& layer) {
    std::vector<std::vector<Vec2>> out;
    bool open = false;
    for (std::size_t k = 0; k < layer.runs.size(); ++k) {
        const BeadRun& p = layer.runs[k];
        if (p.role == toolpath::Role::connector) {
            open = false;
            continue;
        }
        if (!open || !p.continues) out.emplace_back();
        auto& chain = out.back();
        const auto first = layer.points.begin() + p.first + (chain.empty() ? 0 : 1);
        chain.insert(chain.end(), first, layer.points.begin() + static_cast<std::ptrdiff_t>(layer.end(k)));
        open = true;
    }
    return out;
}

// The path from `start`, which is on the segment before chain[next], in direction `step` up to the first point farther
// than r (or the end).
std::vector<Vec2> walk(std::span<const Vec2> chain, Vec2 start, std::ptrdiff_t next, std::ptrdiff_t step, double r) {
    std::vector<Vec2> out{start};
    const auto n = static_cast<std::ptrdiff_t>(chain.size());
    for (; next >= 0 && next < n && out.size() < kMostSteps; next += step) {
        out.push_back(chain[static_cast<std::size_t>(next)]);
        if (geom::distance(start, out.back()) > r) break;
    }
    return out;
}

// Replaces the last point by the exit from the disc; false if the path does not leave it.
bool leave(std::vector<Vec2>& path, double r) {
    if (path.size() < 2 || geom::distance(path.front(), path.back()) <= r) return false;
    const Vec2 a = path[path.size() - 2] - path.front(), d = path.back() - path[path.size() - 2];
    const double b = dot(a, d), c = dot(a, a) - r * r, dd = dot(d, d);
    const double t = (-b + std::sqrt(std::max(0.0, b * b - dd * c))) / dd;
    path.back() = path[path.size() - 2] + std::clamp(t, 0.0, 1.0) * d;
    return true;
}

void smallest_radius(std::span<const Vec2> chain, double scale, Turns& out) {
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
        const double r = toolpath::radius_at(chain, false, i, scale);
        if (r < out.min_radius) {
            out.min_radius = r;
            out.at = chain[i];
        }
    }
}

struct LayerTurns {
    std::vector<std::vector<Vec2>> chain;
    double length = 0;
    Turns turns;
};

// Samples at (k + 1/2) * spacing along all layers, those within [begin, begin + layer.length).
void sample(LayerTurns& layer, double begin, double spacing, double w) {
    double at = begin;
    for (const auto& chain : layer.chain) {
        for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
            const double l = geom::distance(chain[i], chain[i + 1]);
            for (auto k = static_cast<std::int64_t>(std::ceil(at / spacing - 0.5));
                 (static_cast<double>(k) + 0.5) * spacing < at + l; ++k) {
                const double t = ((static_cast<double>(k) + 0.5) * spacing - at) / l;
                const Vec2 p = geom::lerp(chain[i], chain[i + 1], std::clamp(t, 0.0, 1.0));
                const auto next = static_cast<std::ptrdiff_t>(i);
                const double share = disc_share(walk(chain, p, next + 1, 1, w), walk(chain, p, next, -1, w), w);
                if (share < 0) continue;
                ++layer.turns.samples;
                layer.turns.sharp += share < kSharp ? 1 : 0;
            }
            at += l;
        }
    }
}

} // namespace

double disc_share(std::span<const Vec2> forwards, std::span<const Vec2> backwards, double r) {
    std::vector<Vec2> ahead(forwards.begin(), forwards.end()), back(backwards.begin(), backwards.end());
    if (!leave(ahead, r) || !leave(back, r)) return -1;
    const Vec2 o = ahead.front();
    double twice = 0; // twice the area between path and circle on the path's left
    for (std::size_t i = 0; i + 1 < back.size(); ++i) twice += geom::cross(back[i + 1] - o, back[i] - o);
    for (std::size_t i = 0; i + 1 < ahead.size(); ++i) twice += geom::cross(ahead[i] - o, ahead[i + 1] - o);
    const Vec2 u = ahead.back() - o, v = back.back() - o;
    double angle = std::atan2(geom::cross(u, v), dot(u, v)); // of the circle from the exit to the entry
    if (angle < 0) angle += 2 * std::numbers::pi;
    const double share = std::clamp((twice / (r * r) + angle) / (2 * std::numbers::pi), 0.0, 1.0);
    return std::min(share, 1 - share);
}

Turns turns(const Beads& beads, double w, std::size_t samples, int threads) {
    std::vector<const std::pair<const std::uint32_t, LayerBeads>*> layer;
    for (const auto& l : beads.layer) layer.push_back(&l);
    std::vector<LayerTurns> part(layer.size());
    std::vector<double> begin(layer.size() + 1, 0);
    for (std::size_t i = 0; i < layer.size(); ++i) { // lengths only; chains are computed again when they are used
        for (const auto& chain : chains(layer[i]->second)) part[i].length += geom::length(chain);
        begin[i + 1] = begin[i] + part[i].length;
    }
    const double spacing = begin.back() / static_cast<double>(std::max<std::size_t>(1, samples));
    parallel::for_chunks(layer.size(), 1, threads, [&](std::size_t i, std::size_t) {
        part[i].chain = chains(layer[i]->second);
        part[i].turns.min_radius = INFINITY;
        part[i].turns.layer = layer[i]->first;
        for (const auto& chain : part[i].chain) smallest_radius(chain, w / 2, part[i].turns);
        if (spacing > 0) sample(part[i], begin[i], spacing, w);
        part[i].chain = {};
    });
    Turns out;
    out.min_radius = INFINITY;
    for (const auto& p : part) {
        out.samples += p.turns.samples;
        out.sharp += p.turns.sharp;
        if (p.turns.min_radius < out.min_radius) {
            out.min_radius = p.turns.min_radius;
            out.at = p.turns.at;
            out.layer = p.turns.layer;
        }
    }
    return out;
}

} // namespace filum::metrics::planar
