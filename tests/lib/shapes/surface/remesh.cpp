// Remeshing keeps the shape; cutting keeps one side.
#include "surface/remesh.hpp"
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::surface {
namespace {

// [0, 8] x [0, 6] bent upwards by `lift`, a square of 2 mm missing in the middle.
Surface frame_of(double (*lift)(double)) {
    mesh::Mesh m;
    for (int j = 0; j <= 6; ++j)
        for (int i = 0; i <= 8; ++i) m.vertices.push_back({double(i), double(j), lift(i)});
    const auto at = [](int i, int j) { return static_cast<std::uint32_t>(j * 9 + i); };
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 8; ++i)
            if (!(i >= 3 && i < 5 && j >= 2 && j < 4))
                m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                       {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    return connect(m, notes);
}
double flat(double) { return 0; }
double roof(double x) { return x < 4 ? x : 8 - x; }
double bowl(double x) { return 0.05 * (x - 4) * (x - 4); }

double longest(const Surface& s) {
    double out = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) out = std::max(out, side_length(s, h));
    return out;
}

TEST(Remesh, KeepsRimsAndShapeAndMakesSidesAlike) {
    for (const auto lift : {flat, roof, bowl}) {
        const Surface before = frame_of(lift);
        for (const double edge : {2.0, 0.7, 0.3}) {
            Notes notes;
            const Surface after = remesh(before, edge, notes);
            EXPECT_TRUE(notes.empty());
            EXPECT_EQ(after.components, 1U);
            ASSERT_EQ(after.rims.size(), 2U);
            const auto outer = [](const Surface& s) { return s.rims[0].outer ? 0U : 1U; };
            for (const unsigned k : {0U, 1U})
                EXPECT_NEAR(rim_length(after, after.rims[k ^ outer(after)]),
                            rim_length(before, before.rims[k ^ outer(before)]), 1e-9);
            EXPECT_NEAR(area(after), area(before), lift == bowl ? 0.05 : 1e-9);
            for (const Vec3& v : after.vertices) EXPECT_LT(distance(nearest(before, v).a, v), 1e-9);
            if (edge < 1) {
                EXPECT_LT(longest(after), 1.6 * edge);
                EXPECT_NEAR(mean_edge(after), edge, 0.2 * edge);
            }
        }
    }
}

TEST(Remesh, IsTheSameEveryTime) {
    Notes notes;
    const Surface s = frame_of(bowl);
    const Surface a = remesh(s, 0.4, notes), b = remesh(s, 0.4, notes);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
}

// A tetrahedron with a fin on one side: of the three triangles there one is cut off, but its ends stay vertices of the
// other two, as the surface goes on around both.
TEST(Remesh, TakesAnEdgeThatWasCut) {
    const mesh::Mesh m{{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, -2, 0}, {1, -1, 2}},
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 4, 3}, {1, 3, 4}}};
    Notes notes;
    const Surface before = connect(m, notes);
    ASSERT_EQ(before.vertices.size(), 5U);
    ASSERT_EQ(before.components, 1U);
    for (const double edge : {1.0, 0.4}) {
        const Surface after = remesh(before, edge, notes);
        EXPECT_NEAR(area(after), area(before), 1e-9);
        EXPECT_EQ(after.components, 1U);
        EXPECT_EQ(after.rims.size(), before.rims.size());
    }
}

TEST(Remesh, RefusesWhatIsTooFine) {
    Notes notes;
    EXPECT_THROW(remesh(frame_of(flat), 1e-6, notes), Error);
}

TEST(Cut, KeepsTheLowerSide) {
    const Surface s = frame_of(flat);
    Notes notes;
    EXPECT_NEAR(area(cut(s, {{1, 0, 0}, 3}, notes)), 18, 1e-12); // along sides
    EXPECT_NEAR(area(cut(s, {{2, 0, 0}, 5}, notes)), 15, 1e-12);
    EXPECT_NEAR(area(cut(s, {{-1, 0, 0}, -2.5}, notes)), 33 - 4, 1e-12);
    EXPECT_NEAR(area(cut(s, {{1, 1, 0}, 2}, notes)), 2, 1e-12); // through corners
    const Surface half = cut(s, {{0, 1, 0}, 3.3}, notes);
    EXPECT_NEAR(area(half), 8 * 3.3 - 2 * 1.3, 1e-12);
    EXPECT_EQ(half.rims.size(), 1U); // through the hole
    EXPECT_EQ(cut(s, {{1, 0, 0}, 4}, notes).components, 1U);
    EXPECT_NEAR(area(cut(s, {{1, 0, 0}, 50}, notes)), 44, 1e-12);
    EXPECT_TRUE(notes.empty());
    EXPECT_THROW(cut(s, {{1, 0, 0}, -1}, notes), Error);
    EXPECT_THROW(cut(s, {{1, 0, 0}, 0}, notes), Error);
}

} // namespace
} // namespace filum::surface
