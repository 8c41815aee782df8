#include "surface/curve/raise.hpp"

#include "parallel/parallel.hpp"
#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace filum::surface::curve {

namespace {

constexpr int kSteps = 20;             // most steps towards the level
constexpr int kSpreads = 30;           // most rounds that spread folds
constexpr double kOnLevel = 1e-6;      // relative accuracy of a vertex's distance
constexpr double kOffLevel = 0.01;     // greatest distances: larger errors are reported
constexpr std::size_t kVertices = 512; // vertices per task

// A surface and the intended distance above each of its vertices.
struct RaiseTarget {
    const Surface& surface;
    std::span<const double> distance; // mm, per vertex
    Locator near;

    [[nodiscard]] double at(const Place& place) const {
        const auto w = barycentric(surface, place);
        const auto& c = surface.triangles[place.triangle];
        return std::max(0.0, w[0] * distance[c[0]] + w[1] * distance[c[1]] + w[2] * distance[c[2]]);
    }
};

// Moves `p` along the line to its nearest place until that is at the intended distance, on the side that the surface
// faces.
Vec3 on_level(const RaiseTarget& target, Vec3 p) {
    for (int step = 0; step < kSteps; ++step) {
        const Place foot = target.near.nearest(p);
        const double asked = target.at(foot);
        const Vec3 off = p - foot.point, up = surface::normal(target.surface, foot.triangle);
        const bool above = dot(off, up) > 0;
        const double d = above ? norm(off) : -norm(off);
        if (std::abs(d - asked) <= kOnLevel * asked) break;
        p = above ? foot.point + asked / d * off : foot.point + asked * up;
    }
    return p;
}

Vec3 across_triangle(const Surface& s, const std::vector<Vec3>& at, std::uint32_t t) {
    const auto& c = s.triangles[t];
    return cross(at[c[1]] - at[c[0]], at[c[2]] - at[c[0]]);
}

std::vector<char> folds(const Surface& s, const std::vector<Vec3>& at) {
    std::vector<char> out(s.triangles.size(), 0);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        out[t] = dot(across_triangle(s, at, t), surface::normal(s, t)) > 0 ? 0 : 1;
    return out;
}

// Moves every inner corner of a fold, and of its neighbours, to the mean of the vertices around it.
bool spread(const RaiseTarget& target, std::vector<Vec3>& at) {
    const Surface& s = target.surface;
    const auto folded = folds(s, at);
    std::vector<char> moves(s.vertices.size(), 0);
    for (int ring = 0; ring < 2; ++ring) {
        auto wider = moves;
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
            const auto& c = s.triangles[t];
            if (folded[t] != 0 || moves[c[0]] + moves[c[1]] + moves[c[2]] > 0)
                for (const std::uint32_t v : c) wider[v] = 1;
        }
        moves.swap(wider);
    }
    if (std::none_of(moves.begin(), moves.end(), [](char m) { return m != 0; })) return false;
    const std::vector<Vec3> old = at;
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) {
        if (moves[v] == 0 || s.on_rim(v)) continue;
        Vec3 sum;
        double n = 0;
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            sum = sum + old[s.head(h)];
            ++n;
        });
        at[v] = on_level(target, 1 / n * sum);
    }
    return true;
}

void judge(const RaiseTarget& target, const std::vector<Vec3>& at, RaisedSurface& out) {
    const Surface& s = target.surface;
    const double most = *std::max_element(target.distance.begin(), target.distance.end());
    std::vector<char> close(s.vertices.size(), 0);
    for (std::size_t v = 0; v < at.size(); ++v) {
        const Place foot = target.near.nearest(at[v]);
        const double off = target.at(foot) - geom::distance(at[v], foot.point);
        out.worst = std::max(out.worst, std::abs(off));
        close[v] = off > kOffLevel * most ? 1 : 0;
    }
    const auto folded = folds(s, at);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto& c = s.triangles[t];
        if (folded[t] != 0) {
            if (!(out.folded > 0)) out.folded_at = s.vertices[c[0]];
            out.folded += surface::area(s, t);
        }
        if (close[c[0]] + close[c[1]] + close[c[2]] > 0) {
            if (!(out.blocked > 0)) out.blocked_at = s.vertices[c[0]];
            out.blocked += surface::area(s, t);
        }
    }
}

} // namespace

RaisedSurface raised(const Surface& s, std::span<const double> distance) {
    RaisedSurface out{s, 0, 0, 0, {}, {}};
    if (std::none_of(distance.begin(), distance.end(), [](double d) { return d > 0; })) return out;
    const auto ways = vertex_normals(s);
    const RaiseTarget target{s, distance, Locator(s)};
    std::vector<Vec3> at(s.vertices.size());
    parallel::for_chunks(at.size(), kVertices, 0, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) at[v] = on_level(target, s.vertices[v] + distance[v] * ways[v]);
    });
    for (int round = 0; round < kSpreads && spread(target, at); ++round) {
    }
    judge(target, at, out);
    out.surface.vertices = std::move(at);
    return out;
}

RaisedSurface raised(const Surface& s, double distance) {
    const std::vector<double> all(s.vertices.size(), distance);
    return raised(s, all);
}

Surface turned_over(const Surface& s) {
    // The corners (a, b, c) become (a, c, b): half-edge k of a triangle becomes 2 - k.
    const auto other = [](std::uint32_t h) { return h == surface::kNone ? h : h / 3 * 3 + 2 - h % 3; };
    auto triangles = s.triangles;
    for (auto& t : triangles) std::swap(t[1], t[2]);
    std::vector<std::uint32_t> twin(s.twin.size());
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) twin[other(h)] = other(s.twin[h]);
    return surface::assemble(s.vertices, std::move(triangles), std::move(twin));
}

} // namespace filum::surface::curve
