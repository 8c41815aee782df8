#include "surface/curve/transfer.hpp"

#include "surface/remesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace filum::surface::curve {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// [0, 10] x [0, 10] at height z, facing up or down.
mesh::Mesh plate(double z, bool up) {
    mesh::Mesh m;
    for (int j = 0; j <= 10; ++j)
        for (int i = 0; i <= 10; ++i) m.vertices.push_back({1.0 * i, 1.0 * j, z});
    for (std::uint32_t j = 0; j < 10; ++j)
        for (std::uint32_t i = 0; i < 10; ++i) {
            const std::uint32_t a = 11 * j + i;
            m.triangles.push_back({a, a + 1, a + 12});
            m.triangles.push_back({a, a + 12, a + 11});
        }
    if (!up)
        for (auto& t : m.triangles) std::swap(t[1], t[2]);
    return m;
}

TEST(Carry, LinearFieldsStayAndDirectionsKeepTheirLength) {
    Notes notes;
    const Surface from = surface::connect(plate(0, true), notes);
    surface::Field number{"n", {}, 1}, way{"w", {}, 3}, part{"p", {}, 1};
    for (std::size_t v = 0; v < from.vertices.size(); ++v) {
        const Vec3 p = from.vertices[v];
        const double angle = 0.05 * p.x, sign = v % 2 == 0 ? 1 : -1; // the sign of a direction tells nothing
        number.values.push_back(2 * p.x - p.y);
        part.values.push_back(p.x < 4.5 ? 1 : kFar);
        way.values.insert(way.values.end(), {sign * std::cos(angle), sign * std::sin(angle), 0});
    }
    const Surface to = surface::remesh(from, 0.4, notes);
    const auto out = transferred(from, std::vector{number, way, part}, to);
    ASSERT_EQ(out.size(), 3U);
    for (std::size_t v = 0; v < to.vertices.size(); ++v) {
        const Vec3 p = to.vertices[v];
        EXPECT_NEAR(out[0].values[v], 2 * p.x - p.y, 1e-9);
        EXPECT_NEAR(norm(out[1].vector(v)), 1, 1e-9);
        EXPECT_NEAR(std::abs(out[1].vector(v).y), std::sin(0.05 * p.x), 0.01);
        if (std::abs(p.x - 4.5) < 0.5 + 1e-6) continue; // in triangles of both
        const double value = out[2].values[v];
        EXPECT_TRUE(p.x < 4.5 ? std::abs(value - 1) < 1e-12 : value == kFar) << value;
    }
}

TEST(Carry, CadFacesEndWhereTheyDid) {
    Notes notes;
    mesh::Mesh m = plate(0, true);
    for (const auto& t : m.triangles)
        m.faces.push_back(m.vertices[t[0]].x + m.vertices[t[1]].x + m.vertices[t[2]].x < 15 ? 7 : 2);
    std::vector<std::uint32_t> faces;
    const Surface from = surface::connect(m, notes, &faces);
    ASSERT_EQ(faces, m.faces);
    const Surface to = surface::remesh(surface::cut(from, {{0, 1, 0}, 6.3}, notes), 0.4, notes);
    const auto out = transferred_faces(from, faces, to);
    ASSERT_EQ(out.size(), to.triangles.size());
    std::size_t checked = 0;
    for (std::size_t t = 0; t < out.size(); ++t) {
        double x = 0;
        for (const auto v : to.triangles[t]) x += to.vertices[v].x / 3;
        EXPECT_EQ(out[t], x < 5 ? 7U : 2U);
        ++checked;
    }
    EXPECT_GT(checked, 500U);
    EXPECT_TRUE(transferred_faces(from, {}, to).empty());
}

TEST(Carry, AThinWallsSkinsAreNotMixedUp) {
    Notes notes;
    mesh::Mesh both = plate(0, false), top = plate(0.02, true);
    const auto n = static_cast<std::uint32_t>(both.vertices.size());
    both.vertices.insert(both.vertices.end(), top.vertices.begin(), top.vertices.end());
    for (const auto& [a, b, c] : top.triangles) both.triangles.push_back({a + n, b + n, c + n});
    const Surface from = surface::connect(both, notes);
    surface::Field skin{"skin", {}, 1};
    for (const Vec3& p : from.vertices) skin.values.push_back(p.z > 0.01 ? 1 : -1);
    for (Vec3& v : top.vertices) v.z = 0.005; // nearer to the lower skin, but facing as the upper one
    const auto out = transferred(from, std::vector{skin}, surface::connect(top, notes));
    for (const double v : out[0].values) EXPECT_EQ(v, 1);
}

} // namespace
} // namespace filum::surface::curve
