// What lies about the rims of a surface: as deep as asked, and nowhere over itself.
#include "surface/flange.hpp"

#include "../../trials.hpp"
#include "geom/angle.hpp"
#include "grid.hpp"
#include "surface/curve/walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace filum::surface {
namespace {

Vec3 flat(geom::Vec2 p) { return {p.x, p.y, 0}; }

Surface connected(mesh::Mesh mesh) {
    Notes notes;
    return connect(std::move(mesh), notes);
}

double flange_area(const FlangedSurface& f) {
    double out = 0;
    for (std::uint32_t t = f.part; t < f.surface.triangles.size(); ++t) out += area(f.surface, t);
    return out;
}

double lid_area(const FlangedSurface& f) {
    double out = 0;
    for (const Lid& lid : f.lids) out += lid.area;
    return out;
}

// How many triangles a point of the plane lies in, well inside.
int layers(const Surface& s, const Vec3& p) {
    int out = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const auto w = curve::barycentric(s, {t, p});
        out += std::min({w[0], w[1], w[2]}) > 1e-6 ? 1 : 0;
    }
    return out;
}

TEST(Flange, OfAPlateIsAStripWithRoundCorners) {
    const auto f = flanged(connected(grid(30, 20, 3, 2, flat)), 0.5, 4);
    EXPECT_EQ(f.part, 12U);
    EXPECT_NEAR(flange_area(f), 100 * 4 + 4 * 3 * 0.5 * 16 * std::sin(std::numbers::pi / 6), 1e-9);
    EXPECT_EQ(f.least, 4);
    EXPECT_EQ(f.surface.rims.size(), 1U);
    double near = 0;
    for (std::uint32_t t = f.part; t < f.surface.triangles.size(); ++t) near += f.far[t] ? 0 : area(f.surface, t);
    EXPECT_NEAR(near, 100 * 0.5 + 3 * 0.25, 1e-9);
}

TEST(Flange, GoesOnInTheTangentPlanes) {
    const Surface s = connected(grid(std::numbers::pi, 10, 60, 5, [](geom::Vec2 p) {
        return Vec3{10 * std::cos(p.x / 1), p.y, 10 * std::sin(p.x / 1)};
    }));
    const auto f = flanged(s, 0.5, 3);
    for (std::size_t v = s.vertices.size(); v < f.surface.vertices.size(); ++v) {
        const Vec3 &p = f.surface.vertices[v], &q = s.vertices[f.root[v]];
        const Vec3 radial{q.x / 10, 0, q.z / 10};
        EXPECT_LT(std::abs(dot(p - q, radial)), 0.1 * distance(p, q));
    }
}

// A hole like a C that ends in two chambers, in which there is room: so it is no narrow hole, and no notch.
TEST(Flange, InAHoleLeavesHalfOfItFree) {
    const auto off = [](const Vec3& p) { return std::abs(std::hypot(p.x - 20, p.y - 20) - 10); };
    const auto hole = [&](geom::Vec2 p) {
        const bool chamber = std::abs(p.x - 27) < 6.5 && std::abs(std::abs(p.y - 20) - 11) < 6.5;
        return chamber || (off(flat(p)) < 3 && p.x < 24);
    };
    const auto f = flanged(connected(pierced_grid(40, 40, 80, 80, flat, hole)), 0.5, 3);
    EXPECT_LT(lid_area(f), 1); // in steps of the grid
    for (std::uint32_t t = f.part; t < f.surface.triangles.size(); ++t)
        for (const std::uint32_t v : f.surface.triangles[t])
            if (const Vec3& p = f.surface.vertices[v]; std::hypot(p.x - 20, p.y - 20) < 15 && p.x < 20) {
                EXPECT_GT(off(p), 1);
            }
    EXPECT_LT(f.least, 0.5); // in the corners of its steps
}

TEST(Flange, ClosesAHoleWithoutRoomForIt) {
    const auto hole = [](geom::Vec2 p) { return std::hypot(p.x - 20, p.y - 20) < 5; };
    const Surface s = connected(pierced_grid(40, 40, 80, 80, flat, hole));
    const auto closed = flanged(s, 0.5, 6);
    ASSERT_EQ(closed.lids.size(), 1U);
    EXPECT_NEAR(closed.lids[0].middle.x, 20, 0.1);
    EXPECT_NEAR(closed.lids[0].area + area(s), 1600, 1e-9);
    EXPECT_EQ(closed.surface.rims.size(), 1U);
    EXPECT_EQ(closed.least, 6);
    EXPECT_TRUE(s.on_rim(closed.lids[0].vertex));
}

// Of a cone that is open at both ends: the narrow one is a hole only where the cone is flat.
TEST(Flange, ClosesNoTip) {
    const auto lids = [](double steep, double depth) {
        mesh::Mesh m = grid(1, 20, 24, 10, [&](geom::Vec2 p) {
            const double a = 2 * std::numbers::pi * p.x, r = 3 + p.y * std::cos(steep);
            return Vec3{r * std::cos(a), r * std::sin(a), p.y * std::sin(steep)};
        });
        for (mesh::Triangle& t : m.triangles)
            for (std::uint32_t& v : t) v -= v % 25 == 24 ? 24 : 0; // it comes round
        return flanged(connected(std::move(m)), 0.5, depth).lids.size();
    };
    EXPECT_EQ(lids(geom::radians(60), 8), 0U);
    EXPECT_EQ(lids(geom::radians(20), 8), 1U);
    EXPECT_EQ(lids(0, 8), 1U);
    EXPECT_EQ(lids(0, 1), 0U); // there is room
}

// As cutting a mesh along a curve leaves it: vertices anywhere along it, and off it by rounding or noise, so that the
// sides point anywhere.
TEST(Flange, FollowsARoughRimNotItsSides) {
    std::mt19937 random(7);
    const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    std::vector<geom::Vec2> rough; // angle, radius
    for (int k = 0; k < 500; ++k) rough.push_back({std::numbers::pi / 250 * (k + 0.9 * noise()), 12 + 0.04 * noise()});
    mesh::Mesh m = grid(500, 10, 500, 4, [&](geom::Vec2 p) {
        const auto [a, r] = rough[static_cast<std::size_t>(std::lround(p.x)) % 500];
        const double out = p.y == 0 ? r : 12 + p.y;
        return Vec3{out * std::cos(a), out * std::sin(a), 0};
    });
    for (mesh::Triangle& t : m.triangles)
        for (std::uint32_t& v : t) v -= v % 501 == 500 ? 500 : 0; // it comes round
    const auto f = flanged(connected(std::move(m)), 0.5, 5);      // half of the hole's radius is 6
    EXPECT_TRUE(f.lids.empty());
    EXPECT_GT(f.least, 4.9);
    EXPECT_NEAR(flange_area(f), std::numbers::pi * (144 - 49 + 27 * 27 - 22 * 22), 20);
    for (std::uint32_t t = f.part; t < f.surface.triangles.size(); ++t)
        EXPECT_NEAR(normal(f.surface, t).z, normal(f.surface, 0).z, 1e-9);
}

// Surfaces with rims at random, of steps, notches and holes.
TEST(Flange, NeverLiesOverItself) {
    for (int seed = 0; seed < trials(20); ++seed) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
        std::vector<std::array<double, 3>> holes;
        holes.resize(5);
        for (auto& h : holes) h = {20 * unit(), 20 * unit(), 1 + 4 * unit()};
        const auto hole = [&](geom::Vec2 p) {
            for (const auto& [x, y, r] : holes)
                if (std::hypot(p.x - x, p.y - y) < r) return true;
            return false;
        };
        const Surface s = connected(pierced_grid(20, 20, 16, 16, flat, hole));
        const auto f = flanged(s, 0.5, 1 + 6 * unit());
        for (std::uint32_t t = 0; t < f.surface.triangles.size(); ++t)
            EXPECT_GT(normal(f.surface, t).z, 0.99) << "seed " << seed;
        for (int k = 0; k < 1500; ++k)
            EXPECT_LE(layers(f.surface, {30 * unit() - 5, 30 * unit() - 5, 0}), 1) << "seed " << seed;
    }
}

} // namespace
} // namespace filum::surface
