// Any triangles become a manifold, and notes report the changes.
#include "surface/surface.hpp"
#include "base/error.hpp"
#include "surface/section.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::surface {
namespace {

std::vector<Vec3> grid(int n, int m) {
    std::vector<Vec3> out;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) out.push_back({double(i), double(j), 0});
    return out;
}

// Cells of a grid, two triangles each, those for which `without` holds left out.
template <class Without>
std::vector<Triangle> cells(int n, int m, const Without& without) {
    std::vector<Triangle> out;
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            if (!without(i, j))
                out.insert(out.end(),
                           {{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    return out;
}

std::size_t counted(const Notes& notes, const char* what) {
    std::size_t out = 0;
    for (const Note& n : notes)
        if (code_name(n).find(what) != std::string::npos) out += n.count;
    return out;
}

TEST(Surface, FindsRimsAndWhichIsOuter) {
    Notes notes;
    const Surface s = connect(
        {grid(9, 5), cells(9, 5, [](int i, int j) { return j > 0 && j < 4 && (i == 1 || i == 5 || i == 6); })}, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(s.components, 1U);
    EXPECT_DOUBLE_EQ(area(s), 45 - 9);
    ASSERT_EQ(s.rims.size(), 3U);
    int outer = 0;
    for (const Rim& rim : s.rims) {
        outer += rim.outer ? 1 : 0;
        EXPECT_EQ(rim.sides.size(), rim.outer ? 28U : rim_length(s, rim) > 9 ? 10U : 8U);
        for (std::size_t i = 0; i < rim.sides.size(); ++i) {
            EXPECT_EQ(s.head(rim.sides[i]), s.tail(rim.sides[(i + 1) % rim.sides.size()]));
            EXPECT_EQ(s.twin[rim.sides[i]], kNone);
        }
    }
    EXPECT_EQ(outer, 1);
}

TEST(Surface, KeepsTheNumbersOfVertices) {
    Notes notes;
    const auto points = grid(4, 3);
    EXPECT_EQ(connect({points, cells(4, 3, [](int, int) { return false; })}, notes).vertices, points);
}

TEST(Surface, LeavesOutCopies) {
    auto triangles = cells(3, 3, [](int, int) { return false; });
    triangles.push_back(triangles[4]);
    triangles.push_back({triangles[5][2], triangles[5][1], triangles[5][0]});
    Notes notes;
    const Surface s = connect({grid(3, 3), triangles}, notes);
    EXPECT_EQ(counted(notes, "triangle-copied"), 2U);
    EXPECT_EQ(s.triangles.size(), 18U);
    EXPECT_EQ(s.rims.size(), 1U);
}

TEST(Surface, TurnsFlippedTriangles) {
    auto triangles = cells(4, 4, [](int, int) { return false; });
    for (const std::size_t t : {3U, 10U, 11U, 20U}) std::swap(triangles[t][0], triangles[t][1]);
    Notes notes;
    const Surface s = connect({grid(4, 4), triangles}, notes);
    EXPECT_EQ(counted(notes, "triangle-turned"), 4U);
    EXPECT_EQ(s.rims.size(), 1U);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) EXPECT_EQ(normal(s, t), (Vec3{0, 0, 1}));
}

TEST(Surface, TakesOutTrianglesWithoutAreaAndLeavesNoGap) {
    // a corner in the middle of the side of its neighbours: a T-joint closed by a triangle without area
    Notes notes;
    const Surface s = connect(
        {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}}}, notes);
    EXPECT_EQ(counted(notes, "triangle-flat"), 1U);
    EXPECT_EQ(s.triangles.size(), 4U);
    EXPECT_DOUBLE_EQ(area(s), 4);
    ASSERT_EQ(s.rims.size(), 1U);
    EXPECT_EQ(s.rims[0].sides.size(), 4U);
    EXPECT_THROW(connect({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, notes), Error);
}

TEST(Surface, CadFacesStayWithTheirTrianglesThroughRepairs) {
    // the same T-joint, one half of the square face 5, the other 8, and a copy
    Notes notes;
    std::vector<std::uint32_t> faces;
    const Surface s = connect({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}},
                               {{0, 1, 4}, {1, 4, 0}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}},
                               {5, 5, 5, 5, 8}},
                              notes, &faces);
    ASSERT_EQ(faces.size(), s.triangles.size());
    double below = 0;
    for (std::uint32_t t = 0; t < faces.size(); ++t) {
        const auto& [a, b, c] = s.triangles[t];
        const Vec3 middle = 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
        EXPECT_EQ(faces[t], middle.y < middle.x ? 5U : 8U);
        below += faces[t] == 5 ? norm(cross(s.vertices[b] - s.vertices[a], s.vertices[c] - s.vertices[a])) / 2 : 0;
    }
    EXPECT_DOUBLE_EQ(below, 2);
}

TEST(Surface, KeepsTheFlattestPairOfACrowdedEdge) {
    // a plate with a rib along its middle
    auto points = grid(2, 1);
    points.push_back({1, 0, 1});
    points.push_back({1, 1, 1});
    auto triangles = cells(2, 1, [](int, int) { return false; });
    triangles.insert(triangles.begin(), {{1, 4, 7}, {1, 7, 6}});
    Notes notes;
    const Surface s = connect({points, triangles}, notes);
    EXPECT_EQ(counted(notes, "edge-crowded"), 1U);
    EXPECT_EQ(counted(notes, "vertex-split"), 2U);
    EXPECT_EQ(s.components, 2U);
    ASSERT_EQ(s.rims.size(), 2U);
    EXPECT_EQ(s.rims[0].sides.size(), 4U); // the rib
    EXPECT_EQ(s.rims[1].sides.size(), 6U); // the plate
}

TEST(Surface, SplitsPartsThatTouchInAPoint) {
    Notes notes;
    const Surface s = connect({grid(2, 2), cells(2, 2, [](int i, int j) { return i != j; })}, notes);
    EXPECT_EQ(counted(notes, "vertex-split"), 1U);
    EXPECT_EQ(s.components, 2U);
    EXPECT_EQ(s.rims.size(), 2U);
    EXPECT_EQ(s.vertices.size(), 8U); // 9 - 2 unused + 1
}

TEST(Surface, CutsABandWithOneSideOpen) {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    const int n = 24;
    for (int i = 0; i < n; ++i)
        for (const double side : {-1.0, 1.0}) {
            const double a = 2 * M_PI * i / n, r = 4 + side * std::cos(a / 2);
            points.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)});
        }
    for (std::uint32_t i = 0; i < n; ++i) {
        std::uint32_t a = 2 * i, b = a + 1, c = 2 * (i + 1), d = c + 1;
        if (i + 1 == n) {
            c = 1;
            d = 0;
        } // half a turn
        triangles.insert(triangles.end(), {{a, c, d}, {a, d, b}});
    }
    Notes notes;
    const Surface s = connect({points, triangles}, notes);
    EXPECT_EQ(counted(notes, "edge-one-sided"), 1U);
    EXPECT_EQ(s.components, 1U);
    EXPECT_EQ(s.rims.size(), 1U);
}

TEST(Surface, MakesAManifoldOfAnyTriangles) {
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        mesh::Mesh m;
        const auto n = 4 + random() % 8;
        for (std::size_t i = 0; i < n; ++i) // some of them in a line
            m.vertices.push_back({double(random() % 3), double(random() % 3), double(random() % 2)});
        const auto all = 1 + random() % 30;
        for (std::size_t i = 0; i < all; ++i) {
            const Triangle t{static_cast<std::uint32_t>(random() % n), static_cast<std::uint32_t>(random() % n),
                             static_cast<std::uint32_t>(random() % n)};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) m.triangles.push_back(t);
        }
        Notes notes;
        try {
            const Surface s = connect(m, notes); // assemble() checks what Surface promises
            EXPECT_GT(area(s), 0);
            std::size_t open = 0, in_rims = 0;
            for (const auto h : s.twin) open += h == kNone ? 1 : 0;
            for (const Rim& rim : s.rims) in_rims += rim.sides.size();
            EXPECT_EQ(open, in_rims);
        } catch (const Error& e) {
            EXPECT_STREQ(e.what(), "cannot use the surface: none of its triangles has an area");
        }
    }
}

TEST(Surface, BrokenPartsAreRefused) {
    const std::vector<Vec3> v{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const auto make = [&](std::vector<Triangle> t, std::vector<std::uint32_t> twin) { return assemble(v, t, twin); };
    constexpr auto o = kNone;
    EXPECT_NO_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, 3, o, 1, o, o}));
    EXPECT_THROW(make({}, {}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, 3, o, 1, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 4}}, {o, 3, o, 1, o, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 1}}, {o, 3, o, 1, o, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, 4, o, o, 1, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, 3, o, o, o, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, 9, o, 1, o, o}), Error);
    EXPECT_THROW(make({{0, 1, 2}, {2, 1, 3}}, {o, o, o, o, o, o}), Error); // two fans at vertex 1
    EXPECT_THROW(make({{0, 1, 2}}, {o, o, o}), Error);                     // vertex 3 has no triangle
}

TEST(Section, OfACube) {
    Notes notes;
    std::vector<Vec3> v;
    for (int i = 0; i < 8; ++i) v.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    const Surface s = connect({v,
                               {{0, 2, 1},
                                {1, 2, 3},
                                {4, 5, 6},
                                {5, 7, 6},
                                {0, 1, 4},
                                {1, 5, 4},
                                {2, 6, 3},
                                {3, 6, 7},
                                {0, 4, 2},
                                {2, 4, 6},
                                {1, 3, 5},
                                {3, 7, 5}}},
                              notes);
    const auto length = [&](const Plane& p) {
        double sum = 0;
        for (const Segment& e : section(s, p)) sum += distance(e.a, e.b);
        return sum;
    };
    EXPECT_DOUBLE_EQ(length({{0, 0, 3}, 0.9}), 4);
    EXPECT_NEAR(length({{1, 1, 1}, 1.5}), 6 * std::sqrt(0.5), 1e-12); // a hexagon
    EXPECT_NEAR(length({{1, 1, 0}, 1}), 2 + 2 * std::sqrt(2), 1e-12); // along two edges and two diagonals
    EXPECT_NEAR(length({{0, 0, 1}, 1}), 4 + std::sqrt(2), 1e-12);     // a whole face: its edges
    EXPECT_EQ(length({{0, 0, 1}, 2}), 0);
    EXPECT_EQ(nearest(s, {0.25, 0.5, 3}).a, (Vec3{0.25, 0.5, 1}));
    EXPECT_EQ(nearest(s, {2, 2, 2}).a, (Vec3{1, 1, 1}));
    EXPECT_EQ(nearest(s, {0.5, -3, -3}).a, (Vec3{0.5, 0, 0}));
}

} // namespace
} // namespace filum::surface
