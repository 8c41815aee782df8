// Which surfaces are planned on larger triangles, and what fields are on sheets with another order.
#include "surfpath/plan/coarse.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "surface/curve/transfer.hpp"
#include "surfpath/plan/refined.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace filum::surfpath::plan {
namespace {

Surface flat(double side, int cells) {
    Notes notes;
    return surface::connect(surface::flat_grid(side, side, cells, cells), notes);
}

TEST(CoarseSide, IsThatOfLinesIfSixteenTimesAsManyTrianglesAreGiven) {
    for (const double longest : {0.5, 1.0, 3.0}) {
        EXPECT_FALSE(coarse_side(flat(20 * longest, 80), longest)) << longest; // 13.9 times as many
        EXPECT_EQ(coarse_side(flat(20 * longest, 90), longest), longest);      // 17.5 times
    }
}

TEST(CoarseSide, LeavesHalfAMillionTrianglesAtMost) {
    const Surface many = flat(300, 510);  // 520,200
    EXPECT_EQ(coarse_side(many, 1), 1);   // 207,846 suffice
    EXPECT_FALSE(coarse_side(many, 0.7)); // 424,176 of them are needed
    EXPECT_FALSE(coarse_side(many, 0.1));
}

// Vertices and triangles in any order: the same fields at the same places, as a search for these places finds them.
TEST(RefinedSheet, FieldsStayAtTheirPlaces) {
    std::mt19937 random(5);
    for (int k = 0; k < 20; ++k) {
        auto mesh = surface::grid(12, 9, 4 + k, 3, [](geom::Vec2 p) { return Vec3{p.x, p.y, p.x * p.y / 50}; });
        std::vector<std::uint32_t> number(mesh.vertices.size());
        for (std::uint32_t v = 0; v < number.size(); ++v) number[v] = v;
        std::shuffle(number.begin(), number.end(), random);
        auto vertices = mesh.vertices;
        for (std::size_t v = 0; v < number.size(); ++v) vertices[number[v]] = mesh.vertices[v];
        mesh.vertices = std::move(vertices);
        for (auto& t : mesh.triangles)
            for (auto& v : t) v = number[v];
        std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
        Notes notes;
        surface::Sheet sheet;
        sheet.surface = surface::connect(std::move(mesh), notes);
        surface::Field number_field{"stress.1.s1", {}, 1}, way{"direction", {}, 3};
        for (std::size_t v = 0; v < number.size(); ++v) {
            const auto value = [&] { return static_cast<double>(random() % 1000) / 8 - 60; };
            number_field.values.push_back(v % 7 == 0 ? std::numeric_limits<double>::infinity() : value());
            for (int i = 0; i < 3; ++i) way.values.push_back(value());
        }
        sheet.fields = {number_field, way};
        const RefinedSheet ordered = refined(sheet, std::numeric_limits<double>::infinity());
        const auto fields = on_refined(sheet, sheet.fields, ordered);
        const auto sought = surface::curve::transferred(sheet.surface, sheet.fields, ordered.sheet.surface);
        ASSERT_EQ(fields.size(), 2U);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(fields[i].values, sought[i].values) << k;
    }
}

} // namespace
} // namespace filum::surfpath::plan
