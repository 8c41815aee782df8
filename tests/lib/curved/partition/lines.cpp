#include "partition/lines.hpp"
#include "base/error.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::partition {
namespace {

double drawn_length(const Surface& s, const std::vector<char>& drawn) {
    double sum = 0;
    for (std::uint32_t h = 0; h < drawn.size(); ++h)
        if (drawn[h] != 0 && (s.twin[h] == kNone || s.twin[h] > h)) sum += surface::side_length(s, h);
    return sum;
}

TEST(Lines, AStraightLineIsAsLongAsItIsAndKeepsTheSurface) {
    Sheet sheet = grid(40, 20, 13, 7, flat);
    sheet.fields.push_back({"x", {}, 1});
    for (const Vec3& v : sheet.surface.vertices) sheet.fields[0].values.push_back(v.x + 2 * v.y);
    std::vector<char> drawn;
    const std::vector<Vec3> line{{3.3, 1.7, 0.5}, {36.1, 17.9, 0}, {20.2, 18.3, 0}};
    EXPECT_NEAR(draw(sheet, drawn, line), 0.5, 1e-12);
    ASSERT_EQ(drawn.size(), sheet.surface.twin.size());
    // Passing through near vertices makes it a little longer.
    const double length = std::hypot(32.8, 16.2) + std::hypot(15.9, 0.4);
    EXPECT_GE(drawn_length(sheet.surface, drawn), length - 1e-9);
    EXPECT_LT(drawn_length(sheet.surface, drawn), 1.01 * length);
    EXPECT_NEAR(surface::area(sheet.surface), 800, 1e-9);
    EXPECT_EQ(sheet.surface.rims.size(), 1U);
    for (std::size_t v = 0; v < sheet.surface.vertices.size(); ++v)
        EXPECT_NEAR(sheet.fields[0].values[v], sheet.surface.vertices[v].x + 2 * sheet.surface.vertices[v].y, 1e-9);
}

TEST(Lines, AcrossFromRimToRimItIsABorder) {
    Options options;
    options.lines = {{{17, -1, 0}, {23, 21, 0}}};
    Notes notes;
    const auto patches = divide(grid(40, 20, 40, 20, flat), options, 1, notes);
    ASSERT_EQ(patches.size(), 2U);
    EXPECT_NEAR(surface::area(patches[0].surface), 400, 20);
    for (const auto& p : patches) {
        EXPECT_EQ(p.surface.rims.size(), 1U);
        double least = 0, most = 0; // mm beyond the line
        for (const Vec3& v : p.surface.vertices) {
            least = std::min(least, v.x - (17 + 6 * v.y / 20));
            most = std::max(most, v.x - (17 + 6 * v.y / 20));
        }
        EXPECT_LT(std::min(-least, most), 0.06); // a twentieth of an edge
        EXPECT_NEAR(std::max(-least, most), 23, 1e-9);
    }
    EXPECT_TRUE(notes.empty()); // a millimetre off, as long as an edge
}

TEST(Lines, AClosedOneCutsOutWhatItEncloses) {
    Options options;
    options.lines = {{{10, 5, 0}, {20, 5, 0}, {20, 13, 0}, {10, 13, 0}, {10, 5, 0}}};
    options.limits.least_area = 20;
    Notes notes;
    const auto patches = divide(grid(40, 20, 33, 17, flat), options, 1, notes);
    ASSERT_EQ(patches.size(), 2U);
    EXPECT_NEAR(surface::area(patches[0].surface), 720, 4);
    EXPECT_NEAR(surface::area(patches[1].surface), 80, 4);
    EXPECT_EQ(patches[0].surface.rims.size(), 2U);
}

TEST(Lines, OneThatEndsWithinStaysASlit) {
    Options options;
    options.lines = {{{10, 10, 0}, {30, 10, 0}}};
    Notes notes;
    const auto patches = divide(grid(40, 20, 40, 20, flat), options, 1, notes); // along edges that are there
    ASSERT_EQ(patches.size(), 1U);
    EXPECT_EQ(patches[0].surface.rims.size(), 2U);
    EXPECT_NEAR(total(patches), 800, 1e-9);
}

TEST(Lines, RoundABallAndFarOff) {
    Sheet sheet = ball(20, 4);
    std::vector<Vec3> ring;
    for (int i = 0; i <= 12; ++i) ring.push_back({30 * std::cos(i * 30 * kDegree), 30 * std::sin(i * 30 * kDegree), 3});
    Options options;
    options.lines = {ring};
    options.limits.bend_deg = 120;
    Notes notes;
    const auto patches = divide(sheet, options, 1, notes);
    ASSERT_EQ(patches.size(), 2U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::seam_moved);
    EXPECT_NEAR(notes[0].amount, std::hypot(30, 3) - 20, 0.1);
}

TEST(Lines, WhereTheSurfaceEndsIsSaid) {
    // Two plates, the line from one to the other.
    mesh::Mesh m{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}};
    Notes notes;
    Sheet sheet;
    sheet.surface = surface::connect(std::move(m), notes);
    std::vector<char> drawn;
    const std::vector<Vec3> line{{0.2, 0.2, 0}, {5.2, 0.2, 0}};
    EXPECT_THROW(draw(sheet, drawn, line), Error);
}

} // namespace
} // namespace filum::partition
