// Distances from lines that run through vertices, along edges, and next to nothing beside them: on flat sheets they are
// those in the plane.
#include "geodesic/exact.hpp"
#include "surface/trace.hpp"

#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace filum::geodesic {
namespace {

using surfaces::Vec2;
using Points = std::vector<Vec2>;

double to_line(const Points& line, Vec2 p) {
    double least = distance(line[0], p);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 d = line[i] - line[i - 1];
        const double l2 = norm2(d), t = l2 > 0 ? std::clamp(dot(p - line[i - 1], d) / l2, 0.0, 1.0) : 0;
        least = std::min(least, distance(line[i - 1] + t * d, p));
    }
    return least;
}

// The greatest error at a vertex.
double error(const surfaces::Sheet& s, const std::vector<Points>& lines) {
    Sources sources;
    for (const Points& line : lines) {
        std::vector<Vec3> points;
        for (const Vec2 p : line) points.push_back({p.x, p.y, 0});
        const auto trace = surface::trace(s.surface, points);
        sources.segments.insert(sources.segments.end(), trace.segments.begin(), trace.segments.end());
    }
    const auto field = exact(s.surface, sources);
    double worst = 0;
    for (std::size_t v = 0; v < s.flat.size(); ++v) {
        double least = std::numeric_limits<double>::infinity();
        for (const Points& line : lines) least = std::min(least, to_line(line, s.flat[v]));
        worst = std::max(worst, std::abs(field.distance[v] - least));
    }
    return worst;
}

surfaces::Sheet regular(int n) { // diagonals one way, vertices on whole numbers
    std::vector<Vec3> v;
    std::vector<mesh::Triangle> t;
    surfaces::Sheet out;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            v.push_back({1.0 * i, 1.0 * j, 0});
            out.flat.push_back({1.0 * i, 1.0 * j});
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            t.insert(t.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    out.surface = surfaces::make(std::move(v), std::move(t));
    return out;
}

Points circle(Vec2 c, double r, int n, bool closed) {
    Points out;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n;
        out.push_back({c.x + r * std::cos(a), c.y + r * std::sin(a)});
    }
    if (closed) out.push_back(out[0]);
    return out;
}

TEST(Polylines, AClosedOneMayBeginOnAVertex) {
    const auto s = regular(50);
    for (const bool closed : {true, false})
        for (const int n : {4, 7, 40, 400}) EXPECT_LT(error(s, {circle({25, 25}, 10, n, closed)}), 1e-9) << n;
}

// The nearer a corner lies to a vertex or an edge, the narrower are the windows that it sends across there.
TEST(Polylines, CornersNextToVerticesAndEdgesLoseNothing) {
    const auto s = regular(20);
    for (double by = 1; by > 1e-13; by /= 10)
        for (const double bend : {1e-3, 0.02, 1.0})
            for (const Vec2 off : {Vec2{by, 0}, {0, by}, {by, 0.6 * by}, {-by, 0.3 * by}, {-0.2 * by, -by}})
                for (const Vec2 at : {Vec2{10, 10}, {10.37, 10}, {10.41, 10.41}}) {
                    const Vec2 p = at + off;
                    const Points line{{p.x - 3, p.y + 5 - bend}, p, {p.x + 3, p.y - 5 - bend}};
                    EXPECT_LT(error(s, {line}), 2e-7)
                        << by << " " << bend << " " << at.x << " " << off.x << "," << off.y;
                }
}

TEST(Polylines, ThroughVerticesAlongEdgesClosedAndOpenSeveral) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
        const auto s = seed % 3 == 0 ? regular(16) : surfaces::sheet(16, 12, 16, 12, seed);
        std::vector<Points> lines(1 + seed % 3);
        for (Points& line : lines) {
            const auto v = random() % s.flat.size(); // of a triangle at a vertex, its sides, or on
            line.push_back(s.flat[v]);
            for (int k = 0; k < 5; ++k) {
                const auto& t = s.surface.triangles[random() % s.surface.triangles.size()];
                const Vec2 a = s.flat[t[0]], b = s.flat[t[1]];
                const double f = unit();
                if (k % 2 == 0) line.push_back(a);
                line.push_back(k % 3 == 0 ? b : k % 3 == 1 ? a + f * (b - a) : a + 0.5 * (b - a));
            }
            if (random() % 2 == 0) line.push_back(line[0]);
        }
        EXPECT_LT(error(s, lines), 2e-7) << seed;
    }
}

} // namespace
} // namespace filum::geodesic
