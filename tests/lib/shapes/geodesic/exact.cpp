// Exact distances against closed forms, and against unfolding every strip of triangles there is.
#include "geodesic/exact.hpp"
#include "geodesic/isolines.hpp"
#include "geodesic/query.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace filum::geodesic {
namespace {

using surface::kNone;
using surfaces::Vec2;

constexpr double kInf = std::numeric_limits<double>::infinity();

double segment_distance(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 d = b - a;
    const double t = norm2(d) > 0 ? std::clamp(dot(p - a, d) / norm2(d), 0.0, 1.0) : 0;
    return distance(a + t * d, p);
}

TEST(Exact, AFlatSheetHasEuclideanDistances) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto s = surfaces::sheet(20, 10, 16, 8, seed);
        std::mt19937 random(seed);
        const auto v = static_cast<std::uint32_t>(random() % s.flat.size());
        const auto field = exact(s.surface, {{v}, {}});
        for (std::size_t i = 0; i < s.flat.size(); ++i)
            ASSERT_NEAR(field.distance[i], distance(s.flat[v], s.flat[i]), 1e-9) << seed;
    }
}

TEST(Exact, PointsAnywhereAreSources) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const auto s = surfaces::sheet(20, 10, 16, 8, seed);
        std::mt19937 random(seed);
        Sources sources;
        std::vector<Vec2> places;
        for (int k = 0; k < 4; ++k) { // inside of a triangle, on a side, on a corner
            const auto t = static_cast<std::uint32_t>(random() % s.surface.triangles.size());
            const auto& [a, b, c] = s.surface.triangles[t];
            const double u = k == 3 ? 0 : 0.3, w = k < 2 ? 0.2 : 0;
            const Vec2 p = (1 - u - w) * s.flat[a] + u * s.flat[b] + w * s.flat[c];
            places.push_back(p);
            sources.segments.push_back({t, {p.x, p.y, 0}, {p.x, p.y, 0}});
        }
        const auto field = exact(s.surface, sources);
        for (std::size_t i = 0; i < s.flat.size(); ++i) {
            double least = kInf;
            for (const Vec2 p : places) least = std::min(least, distance(p, s.flat[i]));
            ASSERT_NEAR(field.distance[i], least, 1e-9) << seed << " " << i;
        }
    }
}

// What is nearer than a line knows how far it is, though windows are kept from what is farther.
TEST(Exact, WhatIsShutCostsNothingAndChangesNothingOnTheNearSide) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const auto s = surfaces::sheet(20, 20, 16, 16, seed);
        const auto from = exact(s.surface, {{0}, {}});
        const double level = 9;
        Sources line;
        for (const Isoline& l : isolines(s.surface, from, std::vector{level}))
            for (std::size_t i = 0; i < l.triangles.size(); ++i)
                line.segments.push_back({l.triangles[i], l.points[i], l.points[(i + 1) % l.points.size()]});
        const auto shut = triangles_beyond(s.surface, from.distance, level + surface::longest_edge(s.surface));
        const auto all = exact(s.surface, line), some = exact(s.surface, line, kInf, from.unfolding, shut);
        std::size_t far = 0;
        for (std::size_t v = 0; v < s.flat.size(); ++v)
            if (from.distance[v] < level)
                ASSERT_NEAR(some.distance[v], all.distance[v], 1e-12) << seed << " " << v;
            else
                far += std::isfinite(some.distance[v]) ? 0 : 1;
        EXPECT_GT(far, 50U);
        EXPECT_LT(some.propagated, all.propagated / 2);
    }
}

TEST(Exact, ALineAcrossABentSheetIsASource) {
    // a quarter of a cylinder between two flats: unrolls to the plane, if triangles follow its rulings
    const double r = 3, flat = 4, bend = r * std::numbers::pi / 2;
    const auto lift = [&](Vec2 p) -> Vec3 {
        if (p.x < flat) return {p.x, p.y, 0};
        const double a = std::min(p.x - flat, bend) / r, rest = std::max(0.0, p.x - flat - bend);
        return {flat + r * std::sin(a), p.y, r - r * std::cos(a) + rest};
    };
    const auto s = surfaces::sheet(2 * flat + bend, 6, 60, 24, 7, lift);
    const auto cut = surface::section(s.surface, {{1, 0, 0}, 2.3});
    ASSERT_GT(cut.size(), 20U);
    const auto field = exact(s.surface, {{}, cut});
    double worst = 0;
    for (std::size_t i = 0; i < s.flat.size(); ++i)
        worst = std::max(worst, std::abs(field.distance[i] - std::abs(s.flat[i].x - 2.3)));
    EXPECT_LT(worst, 3e-3); // of chords: an edge of 0.25 on a radius of 3 is 7e-5 short
    for (std::size_t i = 0; i < s.flat.size(); ++i)
        if (s.flat[i].x < flat - 0.5) { // no triangle beside it is bent
            EXPECT_NEAR(field.distance[i], std::abs(s.flat[i].x - 2.3), 1e-9);
        }
}

TEST(Exact, SlantingSegmentsHaveRoundEnds) {
    const auto s = surfaces::sheet(20, 10, 16, 8, 3);
    const Vec2 a{6.1, 3.3}, b{13.7, 6.9};
    // the segment in pieces, by where it crosses edges
    const Vec2 d = b - a;
    std::vector<Segment> parts;
    for (std::uint32_t t = 0; t < s.surface.triangles.size(); ++t) {
        double lo = 0, hi = 1;
        for (int k = 0; k < 3; ++k) {
            const Vec2 p = s.flat[s.surface.triangles[t][static_cast<std::size_t>(k)]],
                       q = s.flat[s.surface.triangles[t][static_cast<std::size_t>((k + 1) % 3)]];
            const double from = geom::orient(p, q, a), slope = cross(q - p, d);
            if (slope > 0) lo = std::max(lo, -from / slope);
            if (slope < 0) hi = std::min(hi, -from / slope);
            if (slope == 0 && from < 0) hi = -1;
        }
        if (hi - lo < 1e-9) continue;
        const Vec2 p = a + lo * d, q = a + hi * d;
        parts.push_back({t, {p.x, p.y, 0}, {q.x, q.y, 0}});
    }
    ASSERT_GT(parts.size(), 8U);
    const auto field = exact(s.surface, {{}, parts});
    for (std::size_t i = 0; i < s.flat.size(); ++i)
        EXPECT_NEAR(field.distance[i], segment_distance(a, b, s.flat[i]), 1e-9) << s.flat[i].x << " " << s.flat[i].y;
    std::mt19937 random(1);
    for (int k = 0; k < 300; ++k) {
        const auto t = static_cast<std::uint32_t>(random() % s.surface.triangles.size());
        const auto& [u, v, w] = s.surface.triangles[t];
        const double x = static_cast<double>(random()) / 4294967296.0, y = (1 - x) * 0.7;
        const Vec2 p = x * s.flat[u] + y * s.flat[v] + (1 - x - y) * s.flat[w];
        EXPECT_NEAR(distance_at(s.surface, field, t, {p.x, p.y, 0}), segment_distance(a, b, p), 1e-8);
    }
}

TEST(Exact, TheRimIsASource) {
    const auto s = surfaces::sheet(20, 10, 16, 8, 3);
    Sources sources;
    ASSERT_EQ(s.surface.rims.size(), 1U);
    for (const auto h : s.surface.rims[0].sides)
        sources.segments.push_back(
            {h / 3, s.surface.vertices[s.surface.tail(h)], s.surface.vertices[s.surface.head(h)]});
    const auto field = exact(s.surface, sources);
    for (std::size_t i = 0; i < s.flat.size(); ++i) {
        const Vec2 p = s.flat[i];
        EXPECT_NEAR(field.distance[i], std::min({p.x, 20 - p.x, p.y, 10 - p.y}), 1e-9);
    }
}

TEST(Exact, PathsBendAroundHoles) {
    // a square hole [4, 8] x [4, 8] in [0, 12]^2, seen from a corner
    const auto s = surfaces::sheet(
        12, 12, 12, 12, 5,
        [](Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
        [](int i, int j) { return i >= 4 && i < 8 && j >= 4 && j < 8; });
    ASSERT_EQ(s.surface.rims.size(), 2U);
    EXPECT_TRUE(s.surface.rims[0].outer != s.surface.rims[1].outer);
    // the jitter has moved the hole's rim: its corners are where they are
    const auto field = exact(s.surface, {{0}, {}});
    std::vector<Vec2> rim;
    for (const auto& r : s.surface.rims)
        if (!r.outer)
            for (const auto h : r.sides) rim.push_back(s.flat[s.surface.tail(h)]);
    // visibility graph over the vertices of the hole
    const auto clear = [&](Vec2 p, Vec2 q) {
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Vec2 a = rim[k], b = rim[(k + 1) % rim.size()];
            const double u = geom::orient(a, b, p), v = geom::orient(a, b, q), x = geom::orient(p, q, a),
                         y = geom::orient(p, q, b);
            if (u * v < -1e-12 && x * y < -1e-12) return false;
        }
        const Vec2 m = lerp(p, q, 0.5); // between two of its vertices, through it
        double turn = 0;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Vec2 a = rim[k] - m, b = rim[(k + 1) % rim.size()] - m;
            turn += std::atan2(cross(a, b), dot(a, b));
        }
        return std::abs(turn) < 3 || std::abs(std::abs(turn) - std::numbers::pi) < 1e-3;
    };
    std::vector<Vec2> nodes = rim;
    nodes.push_back(s.flat[0]);
    std::vector<double> d(nodes.size(), kInf);
    d.back() = 0;
    for (std::size_t round = 0; round < nodes.size(); ++round)
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t j = 0; j < nodes.size(); ++j)
                if (i != j && d[i] + distance(nodes[i], nodes[j]) < d[j] && clear(nodes[i], nodes[j]))
                    d[j] = d[i] + distance(nodes[i], nodes[j]);
    int bent = 0;
    for (std::size_t v = 0; v < s.flat.size(); ++v) {
        double least = kInf;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (clear(nodes[i], s.flat[v])) least = std::min(least, d[i] + distance(nodes[i], s.flat[v]));
        EXPECT_NEAR(field.distance[v], least, 1e-9) << s.flat[v].x << " " << s.flat[v].y;
        bent += least > distance(s.flat[0], s.flat[v]) + 1e-6 ? 1 : 0;
    }
    EXPECT_GT(bent, 20);
}

TEST(Exact, OverACube) {
    const Surface s = surfaces::cube(2);
    const auto field = exact(s, {{0}, {}});
    EXPECT_NEAR(field.distance[1], 2, 1e-12);
    EXPECT_NEAR(field.distance[3], std::sqrt(8), 1e-12);
    EXPECT_NEAR(field.distance[7], std::sqrt(20), 1e-12); // 2 along, 4 up the unfolded faces
    // the farthest place from a corner is the opposite one, seen six ways
    double farthest = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        for (int i = 0; i <= 20; ++i)
            for (int j = 0; i + j <= 20; ++j) {
                const auto& [a, b, c] = s.triangles[t];
                const Vec3 p =
                    i / 20.0 * s.vertices[a] + j / 20.0 * s.vertices[b] + (20 - i - j) / 20.0 * s.vertices[c];
                farthest = std::max(farthest, distance_at(s, field, t, p));
            }
    EXPECT_NEAR(farthest, std::sqrt(20), 1e-9);
}

TEST(Exact, AroundAVertexOfMoreOrLessThanAFullTurn) {
    // a fan of k like triangles around a vertex, legs of length 1, rim folded up and down
    for (const int k : {3, 4, 5, 8, 10, 12}) {
        const double z = k <= 5 ? 0.3 : 0.8, r = std::sqrt(1 - z * z);
        std::vector<Vec3> v{{0, 0, 0}};
        std::vector<mesh::Triangle> t;
        for (int i = 0; i < k; ++i) {
            const double a = 2 * std::numbers::pi * i / k;
            v.push_back({r * std::cos(a), r * std::sin(a), k % 2 == 0 && i % 2 == 1 ? -z : z});
            t.push_back({0, static_cast<std::uint32_t>(1 + i), static_cast<std::uint32_t>(1 + (i + 1) % k)});
        }
        const double angle = std::acos(dot(v[1], v[2]));
        const Surface s = surfaces::make(v, t);
        const auto field = exact(s, {{1}, {}});
        for (int i = 0; i < k; ++i) {
            const double turn = std::min(i, k - i) * angle;
            EXPECT_NEAR(field.distance[static_cast<std::size_t>(1 + i)],
                        turn < std::numbers::pi ? 2 * std::sin(turn / 2) : 2.0, 1e-12)
                << k << " " << i;
        }
        EXPECT_NEAR(field.distance[0], 1, 1e-12);
    }
}

// Lengths of all straight paths from a vertex to others, by unfolding every strip of triangles that it can see through.
class Unfolder {
  public:
    Unfolder(const Surface& s, const std::vector<Frame>& f, std::uint32_t from)
        : straight(s.vertices.size(), kInf), s_(s), f_(f), crossed_(s.triangles.size(), 0) {
        straight[from] = 0;
        each_outgoing(s, from, [&](std::uint32_t h) {
            straight[s.head(h)] = std::min(straight[s.head(h)], f[h].length);
            const std::uint32_t last = surface::prev(h), out = surface::next(h);
            straight[s.tail(last)] = std::min(straight[s.tail(last)], f[last].length);
            crossed_[h / 3] = 1;
            const Vec2 q{f[h].cx, f[h].cy};
            if (s.twin[out] != kNone) unfold(s.twin[out], q, {f[h].length, 0}, {f[h].length, 0}, q);
            crossed_[h / 3] = 0;
        });
    }
    std::vector<double> straight;

  private:
    // The source is at the origin and sees the strip between `right` and `left`; h runs from a to b, as unfolded.
    void unfold(std::uint32_t h, Vec2 a, Vec2 b, Vec2 right, Vec2 left) {
        if (crossed_[h / 3] != 0) return; // a shortest path crosses no triangle twice
        crossed_[h / 3] = 1;
        const Vec2 x = 1 / f_[h].length * (b - a);
        const Vec2 c = a + f_[h].cx * x + f_[h].cy * geom::left_of(x);
        const bool in_right = cross(right, c) >= 0, in_left = cross(c, left) >= 0;
        if (in_right && in_left) {
            double& d = straight[s_.tail(surface::prev(h))];
            d = std::min(d, norm(c));
        }
        const std::uint32_t hn = s_.twin[surface::next(h)], hp = s_.twin[surface::prev(h)];
        if (hp != kNone && in_left) unfold(hp, a, c, in_right && in_left ? c : right, left);
        if (hn != kNone && in_right) unfold(hn, c, b, right, in_right && in_left ? c : left);
        crossed_[h / 3] = 0;
    }
    const Surface& s_;
    const std::vector<Frame>& f_;
    std::vector<char> crossed_;
};

TEST(Exact, AgreesWithUnfoldingEveryStrip) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Surface s = surfaces::bumpy_sphere(1, 0.3, seed); // 32 triangles
        const auto frame = frames(s);
        const auto n = static_cast<std::uint32_t>(s.vertices.size());
        std::vector<std::vector<double>> d;
        for (std::uint32_t v = 0; v < n; ++v) d.push_back(Unfolder(s, frame, v).straight);
        for (std::uint32_t k = 0; k < n; ++k) // paths that bend at vertices
            for (std::uint32_t i = 0; i < n; ++i)
                for (std::uint32_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
        for (std::uint32_t v = 0; v < n; ++v) {
            const auto field = exact(s, {{v}, {}});
            for (std::uint32_t j = 0; j < n; ++j)
                ASSERT_NEAR(field.distance[j], d[v][j], 1e-11) << seed << " " << v << " " << j;
        }
    }
}

TEST(Exact, IsSymmetricAndSlopesAtMostOne) {
    const Surface s = surfaces::bumpy_sphere(4, 0.05, 4); // 2048 triangles
    const auto a = exact(s, {{17}, {}}), b = exact(s, {{400}, {}});
    EXPECT_NEAR(a.distance[400], b.distance[17], 1e-11);
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        EXPECT_LE(a.distance[s.head(h)], a.distance[s.tail(h)] + a.unfolding->frame[h].length + 1e-11);
    const auto both = exact(s, {{17, 400}, {}});
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        EXPECT_NEAR(both.distance[v], std::min(a.distance[v], b.distance[v]), 1e-11);
}

TEST(Exact, SourcesOfOneFieldAreNoneOfAnotherOnItsGround) {
    const Surface s = surfaces::bumpy_sphere(3, 0.2, 1);
    const auto first = exact(s, {{17}, {}}), alone = exact(s, {{40}, {}});
    const auto second = exact(s, {{40}, {}}, std::numeric_limits<double>::infinity(), first.unfolding);
    EXPECT_EQ(second.unfolding, first.unfolding);
    EXPECT_EQ(second.distance, alone.distance);
    EXPECT_EQ(second.propagated, alone.propagated);
}

TEST(Exact, ASphereIsApproached) {
    const Surface s = surfaces::bumpy_sphere(5, 0, 0);
    const auto field = exact(s, {{4}, {}}); // the north pole
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        EXPECT_NEAR(field.distance[v], std::acos(std::clamp(s.vertices[v].z, -1.0, 1.0)), 2e-3);
}

TEST(Exact, ComponentsWithoutASourceAreInfinitelyFar) {
    std::vector<Vec3> v{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
    const Surface s = surfaces::make(v, {{0, 1, 2}, {3, 4, 5}});
    ASSERT_EQ(s.components, 2U);
    const auto one = exact(s, {{0}, {}});
    EXPECT_EQ(one.distance[1], 1);
    EXPECT_EQ(one.distance[3], kInf);
    EXPECT_EQ(one.distance[5], kInf);
    const auto both = exact(s, {{0, 4}, {}});
    EXPECT_EQ(both.distance[3], 1);
    EXPECT_EQ(distance_at(s, one, 1, {5.2, 0.2, 0}), kInf);
}

TEST(Exact, SliversChangeNothing) {
    // every triangle split near a corner again and again: aspect ratios beyond a thousand
    const auto base = surfaces::sheet(20, 10, 8, 4, 2);
    std::vector<Vec3> v = base.surface.vertices;
    std::vector<mesh::Triangle> t;
    for (const auto& [a, b, c] : base.surface.triangles) {
        const auto m = static_cast<std::uint32_t>(v.size());
        v.push_back(0.9995 * v[a] + 0.0003 * v[b] + 0.0002 * v[c]);
        v.push_back(1e-4 * v[a] + 0.9998 * v[b] + 1e-4 * v[c]);
        t.insert(t.end(), {{a, m + 1, m}, {a, b, m + 1}, {b, c, m + 1}, {m + 1, c, m}, {c, a, m}});
    }
    const Surface s = surfaces::make(v, t);
    ASSERT_EQ(s.vertices.size(), v.size());
    const auto field = exact(s, {{10}, {}});
    for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(field.distance[i], distance(v[10], s.vertices[i]), 1e-7);
}

TEST(Exact, DistancesAloneAreTheSame) {
    const Surface s = surfaces::bumpy_sphere(5, 0.05, 3);
    const Sources sources{{7}, {{100, s.vertices[s.triangles[100][0]], s.vertices[s.triangles[100][1]]}}};
    const auto all = exact(s, sources).distance;
    const ExactDistances alone = exact_distances(s, sources);
    EXPECT_EQ(alone.distance, all);
    EXPECT_EQ(alone.known, kInf);
    const ExactDistances some = exact_distances(s, sources, kInf, alone.propagated / 4);
    EXPECT_LT(some.known, *std::max_element(all.begin(), all.end()));
    std::size_t found = 0;
    for (std::size_t v = 0; v < all.size(); ++v) {
        EXPECT_EQ(some.distance[v], all[v] <= some.known ? all[v] : kInf);
        found += std::isfinite(some.distance[v]) ? 1 : 0;
    }
    EXPECT_GT(found, all.size() / 10);
}

} // namespace
} // namespace filum::geodesic
