// Seams of tubes that do not close to the bit, at many offsets, ways and divisions.
#include "mesh/seams.hpp"

#include "mesh/place.hpp"
#include "mesh/sides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace filum;
using geom::Vec3;

namespace seams {

constexpr double kRadius = 10, kHeight = 20;

// A tube that is cut open along z: `left` and `right` sides along the two rims of the cut, which are up to `off` mm
// apart.
mesh::Mesh tube(int left, int right, double off, std::mt19937& chance) {
    constexpr int kColumns = 24;
    mesh::Mesh m;
    const auto jitter = [&] { return off * (2 * (static_cast<double>(chance()) / 4294967296.0) - 1) / std::sqrt(3); };
    std::vector<std::uint32_t> before;
    for (int c = 0; c <= kColumns; ++c) {
        const int rows = c < kColumns / 2 ? left : right;
        const double angle = 2 * std::numbers::pi * c / kColumns;
        std::vector<std::uint32_t> now;
        for (int r = 0; r <= rows; ++r) {
            now.push_back(static_cast<std::uint32_t>(m.vertices.size()));
            m.vertices.push_back({kRadius * std::cos(angle), kRadius * std::sin(angle), kHeight * r / rows});
            if (c == kColumns) m.vertices.back() = m.vertices.back() + Vec3{jitter(), jitter(), jitter()};
        }
        std::size_t i = 0, j = 0; // up between the two columns
        while (c > 0 && (i + 1 < before.size() || j + 1 < now.size())) {
            const bool step_left = j + 1 == now.size() ||
                                   (i + 1 < before.size() && m.vertices[before[i + 1]].z < m.vertices[now[j + 1]].z);
            if (step_left) {
                m.triangles.push_back({before[i], now[j], before[i + 1]});
                ++i;
            } else {
                m.triangles.push_back({before[i], now[j], now[j + 1]});
                ++j;
            }
        }
        before = now;
    }
    return m;
}

// A zone of a sphere in patches that divide their curved seams differently: gaps as high as arcs over chords remain
// between common points. `rows` are the divisions of each patch, from one rim of the zone to the other.
mesh::Mesh zone(const std::vector<int>& rows, double radius, bool turned) {
    mesh::Mesh m;
    const int columns = 24 / static_cast<int>(rows.size()), patches = static_cast<int>(rows.size());
    for (int p = 0; p < patches; ++p) {
        const auto first = static_cast<std::uint32_t>(m.vertices.size());
        const auto high = static_cast<std::uint32_t>(rows[static_cast<std::size_t>(p)]) + 1;
        for (int c = 0; c <= columns; ++c)
            for (std::uint32_t r = 0; r < high; ++r) {
                const double a = 2 * std::numbers::pi * (p * columns + c) / (patches * columns),
                             b = -0.6 + 1.4 * r / (high - 1);
                m.vertices.push_back(radius * Vec3{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
            }
        for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(columns); ++c)
            for (std::uint32_t r = 0; r + 1 < high; ++r) {
                const std::uint32_t v = first + c * high + r;
                mesh::Triangle one{v, v + high, v + high + 1}, two{v, v + high + 1, v + 1};
                if (turned && p % 2 == 1) {
                    std::swap(one[0], one[1]);
                    std::swap(two[0], two[1]);
                }
                m.triangles.insert(m.triangles.end(), {one, two});
            }
    }
    return m;
}

// mm of sides with one triangle.
double open(const mesh::Mesh& m) {
    double out = 0;
    const auto sides = mesh::half_edges(m);
    mesh::each_edge(sides, [&](std::size_t i, std::size_t j) {
        if (j - i == 1) out += distance(m.vertices[sides[i].low()], m.vertices[sides[i].high()]);
    });
    return out;
}

const Note* find(const Notes& notes, NoteCode code) {
    for (const Note& n : notes)
        if (n.code == code) return &n;
    return nullptr;
}

} // namespace seams

TEST(Seams, AreJoinedUpToAThousandthOfTheSize) {
    const double ends = 2 * 24 * 2 * seams::kRadius * std::sin(std::numbers::pi / 24);
    for (const double off : {1e-15, 1e-9, 1e-6, 1e-4, 1e-3})
        for (const auto& [left, right] : {std::pair{8, 8}, {8, 4}, {4, 12}, {3, 5}, {1, 7}}) {
            std::mt19937 chance(7);
            mesh::Mesh m = seams::tube(left, right, off * seams::kHeight, chance);
            Notes notes;
            mesh::join_seams(m, notes);
            EXPECT_NEAR(seams::open(m), ends, 0.1) << off << ' ' << left << ' ' << right;
            EXPECT_NE(seams::find(notes, NoteCode::rim_joined), nullptr);
            EXPECT_EQ(seams::find(notes, NoteCode::rim_side_split) != nullptr, left != right);
            EXPECT_EQ(seams::find(notes, NoteCode::rim_near), nullptr) << off << ' ' << left << ' ' << right;
        }
}

TEST(Seams, PatchesThatDivideACurvedSeamDifferentlyAreJoined) {
    for (const double radius : {0.5, 50.0, 5000.0})
        for (const bool turned : {false, true})
            for (const std::vector<int>& rows :
                 std::vector<std::vector<int>>{{8, 16}, {4, 12}, {7, 5}, {9, 6, 6, 3}, {13, 12}, {6, 6, 12, 11}}) {
                mesh::Mesh m = seams::zone(rows, radius, turned);
                const double ends = 2 * 24 * std::sin(std::numbers::pi / 24) * radius * (std::cos(0.6) + std::cos(0.8));
                Notes notes;
                mesh::join_seams(m, notes);
                EXPECT_NEAR(seams::open(m), ends, 1e-6 * radius) << radius << ' ' << rows[0] << ' ' << rows[1];
                EXPECT_NE(seams::find(notes, NoteCode::rim_side_split), nullptr);
                EXPECT_EQ(seams::find(notes, NoteCode::rim_near), nullptr);
            }
}

// A disc in two halves whose common diameter is open by a slit with vertices on both sides: no seam.
TEST(Seams, ASlitThatIsNoSeamStaysOpen) {
    for (const double wide : {0.15, 3.0}) {
        mesh::Mesh m;
        constexpr int n = 8;
        for (const double side : {-1.0, 1.0}) {
            const auto first = static_cast<std::uint32_t>(m.vertices.size());
            for (int k = 0; k <= n; ++k)
                m.vertices.push_back({10.0 * k, side * wide * std::sin(std::numbers::pi * k / n), 0});
            for (int k = 0; k <= n; ++k) m.vertices.push_back({10.0 * k, side * 40, 0});
            for (std::uint32_t k = first; k < first + n; ++k)
                m.triangles.insert(m.triangles.end(), {{k, k + 1, k + n + 2}, {k, k + n + 2, k + n + 1}});
        }
        Notes notes;
        mesh::join_seams(m, notes);
        EXPECT_EQ(seams::find(notes, NoteCode::rim_side_split), nullptr);
        const Note* near = seams::find(notes, NoteCode::rim_near); // of the wide slit only its ends are narrow
        ASSERT_NE(near, nullptr);
        EXPECT_NEAR(near->amount, wide < 1 ? 160 : 5, 6);
    }
}

// The poles of a sphere whose points a program computed with sin(pi) are not the same to the bit.
TEST(Seams, VerticesOfOnePointAreJoinedHoweverShortTheirSidesAre) {
    for (const double off : {1e-16, 1e-12, 1e-8}) {
        mesh::Mesh m;
        constexpr std::uint32_t n = 16, rows = 8;
        for (std::uint32_t r = 0; r <= rows; ++r)
            for (std::uint32_t c = 0; c < n; ++c) {
                const double a = 2 * std::numbers::pi * c / n, b = std::numbers::pi * r / rows;
                const double around = r == 0 || r == rows ? off : std::sin(b);
                m.vertices.push_back(10 * Vec3{around * std::cos(a), around * std::sin(a), std::cos(b)});
            }
        for (std::uint32_t r = 0; r < rows; ++r)
            for (std::uint32_t c = 0; c < n; ++c) {
                const std::uint32_t i = r * n + c, j = r * n + (c + 1) % n;
                m.triangles.insert(m.triangles.end(), {{i, i + n, j + n}, {i, j + n, j}});
            }
        Notes notes;
        mesh::join_seams(m, notes);
        EXPECT_EQ(seams::open(m), 0) << off;
        EXPECT_EQ(seams::find(notes, NoteCode::rim_near), nullptr);
    }
}

TEST(Seams, WhatStaysOpenWithinABeadIsNotedWithItsLength) {
    std::mt19937 chance(7);
    mesh::Mesh m = seams::tube(8, 8, 0, chance);
    for (std::size_t v = m.vertices.size() - 9; v < m.vertices.size(); ++v) m.vertices[v].y -= 0.2;
    Notes notes;
    mesh::join_seams(m, notes);
    const Note* n = seams::find(notes, NoteCode::rim_near);
    ASSERT_NE(n, nullptr);
    EXPECT_NEAR(n->amount, 2 * seams::kHeight, 1);
    EXPECT_EQ(notes.size(), 1U);
}

TEST(Seams, ACopyOfASurfaceOnItIsNotJoinedToIt) {
    std::mt19937 chance(7);
    mesh::Mesh m = seams::tube(8, 8, 0, chance);
    m.triangles.resize(m.triangles.size() / 2);
    const auto n = static_cast<std::uint32_t>(m.vertices.size());
    const std::size_t triangles = m.triangles.size();
    for (std::uint32_t v = 0; v < n; ++v) m.vertices.push_back(Vec3(m.vertices[v]) + Vec3{0, 0, 1e-5});
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto [a, b, c] = m.triangles[t];
        m.triangles.push_back({a + n, b + n, c + n});
    }
    Notes notes;
    mesh::join_seams(m, notes);
    EXPECT_TRUE(notes.empty());
}

TEST(Seams, AClosedOrWideOpenMeshIsLeftAsItIs) {
    std::mt19937 chance(7);
    mesh::Mesh m = seams::tube(8, 8, 0, chance);
    m.triangles.resize(m.triangles.size() / 2);
    const auto before = m.triangles;
    Notes notes;
    mesh::join_seams(m, notes);
    EXPECT_EQ(m.triangles, before);
    EXPECT_TRUE(notes.empty());
}
