// Winding numbers of surfaces against sums of solid angles by one arc tangent for each triangle.
#include "mesh/winding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace filum;
using geom::Vec3;

namespace {

// Random triangles, `grid` places along each axis; few places put points on corners, edges and planes of triangles.
mesh::Mesh soup(std::mt19937& chance, std::uint32_t grid, std::size_t triangles) {
    mesh::Mesh m;
    const auto any = [&] { return double(chance() % grid); };
    for (std::uint32_t v = 0; v < 3 * triangles; ++v) m.vertices.push_back({any(), any(), any()});
    for (std::uint32_t t = 0; t < triangles; ++t) m.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    return m;
}

// The winding number without a tree. `doubtful` is set if the point lies on a triangle, where the number jumps.
double by_arc_tangents(const mesh::Mesh& m, const Vec3& p, bool& doubtful) {
    double sum = 0;
    for (const mesh::Triangle& t : m.triangles) {
        const Vec3 a = m.vertices[t[0]] - p, b = m.vertices[t[1]] - p, c = m.vertices[t[2]] - p;
        const double la = norm(a), lb = norm(b), lc = norm(c);
        const double across = dot(a, cross(b, c));
        const double along = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        doubtful = doubtful || (std::abs(across) < 1e-9 * la * lb * lc && along <= 1e-9 * la * lb * lc);
        sum += 2 * std::atan2(across, along);
    }
    return sum / (4 * std::numbers::pi);
}

// A closed box around the origin.
mesh::Mesh box(double half) {
    mesh::Mesh m;
    for (int n = 0; n < 8; ++n)
        m.vertices.push_back({(n & 1) != 0 ? half : -half, (n & 2) != 0 ? half : -half, (n & 4) != 0 ? half : -half});
    m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                   {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return m;
}

} // namespace

TEST(Winding, IsTheSumOfSolidAnglesOnAnySoup) {
    std::size_t compared = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        std::mt19937 chance(seed);
        const std::uint32_t grid = seed % 3 == 0 ? 1000000 : 2 + chance() % 6;
        const mesh::Mesh m = soup(chance, grid, 1 + chance() % 8); // one leaf: no dipole takes part
        const mesh::Winding winding(m, {});
        for (int k = 0; k < 20; ++k) {
            const auto any = [&] { return double(chance() % (2 * grid)) / 2; };
            const Vec3 p{any(), any(), any()};
            bool doubtful = false;
            const double right = by_arc_tangents(m, p, doubtful);
            if (doubtful || std::abs(right) < 0.02) continue; // small angles may come from the dipole
            ASSERT_NEAR(winding.at(p), right, 0.01) << "seed " << seed;
            ++compared;
        }
    }
    EXPECT_GT(compared, 10000U);
}

TEST(Winding, OfManyShellsIsTheirNumberHoweverManyTurnsThatIs) {
    mesh::Mesh shells;
    for (int n = 1; n <= 40; ++n) {
        const mesh::Mesh one = box(1 + 1e-3 * n);
        const auto first = static_cast<std::uint32_t>(shells.vertices.size());
        shells.vertices.insert(shells.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (const mesh::Triangle& t : one.triangles)
            shells.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const mesh::Winding out(shells, {});
    for (mesh::Triangle& t : shells.triangles) std::swap(t[1], t[2]);
    const mesh::Winding in(shells, {});
    std::mt19937 chance(1);
    std::uniform_real_distribution<double> within(-1, 1);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 p{within(chance), within(chance), within(chance)};
        ASSERT_NEAR(out.at(p), 40, 0.4);
        ASSERT_NEAR(in.at(p), -40, 0.4);
        ASSERT_NEAR(out.at(p + Vec3{2.1, 0, 0}), 0, 0.4);
    }
}

TEST(Winding, OfAVeryLargeAndAVerySmallSurfaceIsOneWithin) {
    for (const double half : {1e-9, 1e-3, 1.0, 1e6, 1e12})
        EXPECT_NEAR(mesh::Winding(box(half), {}).at({half / 3, half / 7, half / 11}), 1, 1e-9) << half;
}
