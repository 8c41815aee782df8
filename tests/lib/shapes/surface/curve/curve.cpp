// Walking, laying and easing on surfaces whose answers are known.
#include "surface/curve/ease.hpp"
#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <random>

namespace filum::surface::curve {
namespace {

using std::numbers::pi;

Surface grid(double size, int n, const std::function<Vec3(Vec2)>& lift) {
    std::mt19937 random(3);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    mesh::Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const bool inside = i > 0 && j > 0 && i < n && j < n;
            m.vertices.push_back(
                lift({size * (i + (inside ? 0.5 * unit() : 0)) / n, size * (j + (inside ? 0.5 * unit() : 0)) / n}));
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                   {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    return surface::connect(m, notes);
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }
Vec3 rolled(Vec2 p) { return {10 * std::sin(p.x / 10), p.y, 10 - 10 * std::cos(p.x / 10)}; } // radius 10

void expect_on_surface(const Surface& s, const Line& line) {
    for (const Place& p : line.places) {
        for (const double w : barycentric(s, p)) EXPECT_GE(w, -1e-9);
        EXPECT_LT(distance(surface::nearest_in(s, p.triangle, p.point), p.point), 1e-9);
    }
}

Line polyline(const Surface& s, std::span<const Vec3> points, bool closed = false) {
    const Locator locator(s);
    Line out{{}, closed};
    for (const Vec3& p : points) out.places.push_back(locator.nearest(p));
    return out;
}

TEST(Walk, IsStraightOnAPlaneAndEndsAtItsRim) {
    const Surface s = grid(20, 10, flat);
    const Line line = walk(s, Locator(s).nearest({3, 4, 0}), {2, 1, 5}, 11);
    expect_on_surface(s, line);
    EXPECT_NEAR(length(line), 11, 1e-9);
    const Vec3 end = line.places.back().point;
    EXPECT_NEAR(end.x, 3 + 22 / std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(end.y, 4 + 11 / std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(length(walk(s, Locator(s).nearest({3, 4, 0}), {-1, 0, 0}, 50)), 3, 1e-9);
}

// A cylinder of flat faces unrolls: the straightest line goes on at its angle to the axis.
TEST(Walk, KeepsItsAngleOnACylinder) {
    const int n = 40;
    mesh::Mesh m;
    const double wide = 2 * 10 * std::sin(20.0 / n / 10 / 2);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) m.vertices.push_back(rolled({20.0 * i / n, 20.0 * j / n}));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                   {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    const Surface s = surface::connect(m, notes);
    const double flat_width = wide * n;
    const Line line =
        walk(s, {0, s.vertices[0]}, {std::cos(0.025), 0.5, std::sin(0.025)}, 0.999 * flat_width * std::sqrt(1.25));
    EXPECT_NEAR(line.places.back().point.y, 0.5 * 0.999 * flat_width, 1e-9);
    expect_on_surface(s, line);
}

TEST(Lay, CastsTheShadowAskedFor) {
    const Surface s = grid(20, 40, rolled);
    const Place from = Locator(s).nearest(rolled({10, 10}));
    const Chart map = chart(from, surface::normal(s, from.triangle), {1, 0, 0});
    std::vector<Vec2> circle;
    for (int i = 0; i <= 40; ++i) circle.push_back({2.4 - 2.4 * std::cos(pi * i / 20), 2.4 * std::sin(pi * i / 20)});
    const ChartLine laid = from_chart(s, map, from, circle);
    ASSERT_TRUE(laid.whole);
    expect_on_surface(s, laid.line);
    EXPECT_LT(distance(laid.line.places.back().point, from.point), 1e-9);
    for (const Place& p : laid.line.places) EXPECT_NEAR(norm(map.to(p.point) - Vec2{2.4, 0}), 2.4, 0.01);
    const Vec2 away[] = {{0, 0}, {0, 50}};
    EXPECT_FALSE(from_chart(s, map, from, away).whole);
}

TEST(Lines, PartsAndPlacesAlongThem) {
    const Surface s = grid(20, 10, flat);
    const Vec3 square[] = {{2, 2, 0}, {12, 2, 0}, {12, 12, 0}, {2, 12, 0}};
    const Line line = polyline(s, square, true);
    const auto w = arc_lengths(line);
    EXPECT_DOUBLE_EQ(w.back(), 40);
    EXPECT_NEAR(distance(at(line, w, 45).point, {7, 2, 0}), 0, 1e-9);
    const Line over = part(line, w, 35, 15);
    EXPECT_NEAR(length(over), 20, 1e-9);
    EXPECT_FALSE(over.closed);
    EXPECT_NEAR(distance(over[0], {2, 7, 0}), 0, 1e-9);
    EXPECT_NEAR(distance(over.places.back().point, {12, 7, 0}), 0, 1e-9);
    EXPECT_NEAR(length(part(line, w, 7, 47)), 40, 1e-9);
    Line turned = threaded(s, line);
    EXPECT_GT(turned.size(), line.size());
    expect_on_surface(s, turned);
    reverse(turned);
    for (std::size_t i = 0; i < turned.size(); ++i) // each stretch in the triangle of its first place
        EXPECT_LT(distance(surface::nearest_in(s, turned.places[i].triangle, turned[(i + 1) % turned.size()]),
                           turned[(i + 1) % turned.size()]),
                  1e-9);
    EXPECT_NEAR(length(resampled(line, 1)), 40, 1e-9);
    EXPECT_EQ(resampled(line, 1).size(), 40U);
}

TEST(Locator, FindsWhatTryingAllFinds) {
    const Surface s = grid(8, 12, rolled);
    const Locator locator(s);
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        const Vec3 p{random() % 300 / 10.0 - 5, random() % 300 / 10.0 - 5, random() % 300 / 10.0 - 5};
        const auto all = surface::nearest(s, p);
        const auto found = locator.nearest(p);
        EXPECT_EQ(found.triangle, all.triangle);
        EXPECT_EQ(found.point, all.a);
    }
    EXPECT_EQ(locator.nearest({5, 5, 1}, -1 * surface::normal(s, 0)).triangle, kNone);
}

// A right angle becomes an arc of the radius; how far it moves tells which: r (sqrt 2 - 1).
TEST(Ease, RoundsCornersToTheRadius) {
    for (const bool bent : {false, true}) {
        const Surface s = grid(30, 60, bent ? rolled : flat);
        std::vector<Vec3> points;
        for (int i = 0; i <= 100; ++i) {
            const Vec2 p = i <= 50 ? Vec2{5 + 0.2 * i, 8} : Vec2{15, 8 + 0.2 * (i - 50)};
            points.push_back(bent ? rolled(p) : flat(p));
        }
        const Line line = polyline(s, points);
        const EaseResult eased = ease(s, line, {.radius = 2.4, .corridor = 2, .step = 0.2});
        expect_on_surface(s, eased.line);
        EXPECT_NEAR(eased.moved, 2.4 * (std::sqrt(2.0) - 1), 0.1);
        EXPECT_LT(eased.too_tight, 0.5);
        EXPECT_EQ(eased.line[0], line[0]);
        EXPECT_NEAR(length(line) - length(eased.line), (2 - pi / 2) * 2.4, 0.1);
    }
}

TEST(Ease, LeavesWhatIsGentleAndStaysInItsCorridor) {
    const Surface s = grid(30, 30, flat);
    std::vector<Vec3> circle, hairpin;
    for (int i = 0; i < 200; ++i)
        circle.push_back({15 + 3 * std::cos(pi * i / 100), 15 + 3 * std::sin(pi * i / 100), 0});
    const Line round = polyline(s, circle, true);
    const EaseResult same = ease(s, round, {.radius = 2.4, .corridor = 1, .step = 0.2});
    EXPECT_EQ(same.line.size(), round.size());
    EXPECT_LT(same.moved, 1e-4);
    for (int i = 0; i <= 30; ++i) hairpin.push_back({5 + 0.5 * i, 10, 0});
    for (int i = 30; i >= 0; --i) hairpin.push_back({5 + 0.5 * i, 11, 0});
    const EaseResult held = ease(s, polyline(s, hairpin), {.radius = 2.4, .corridor = 0.3, .step = 0.2});
    EXPECT_LE(held.moved, 0.3 + 1e-9);
    EXPECT_GT(held.too_tight, 0);
}

// A sliver at the rim that lies folded over its neighbour: by angles, half a turn each, normals there cancel.
TEST(Normals, AreThereBesideASliverThatIsFoldedOver) {
    mesh::Mesh mesh;
    mesh.vertices = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1e-9, 0}};
    mesh.triangles = {{0, 3, 2}, {3, 1, 2}, {1, 3, 0}};
    Notes notes;
    const auto s = surface::connect(std::move(mesh), notes);
    const auto flat = vertex_normals(s);
    for (const Vec3& n : flat) EXPECT_NEAR(norm(n), 1, 1e-9);
    EXPECT_NEAR(flat[3].z, 1, 1e-9);
}

} // namespace
} // namespace filum::surface::curve
