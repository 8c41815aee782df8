// A sheet in its components.
#include "surface/components.hpp"

#include <gtest/gtest.h>

namespace filum::surface {
namespace {

TEST(Components, TakeTheirShareOfFieldsAndSources) {
    Notes notes;
    // Two squares, their triangles by turns.
    mesh::Mesh mesh{{{0, 0, 0}, {9, 0, 0}, {1, 0, 0}, {10, 0, 0}, {1, 1, 0}, {10, 1, 0}, {0, 1, 0}, {9, 1, 0}},
                    {{0, 2, 4}, {1, 3, 5}, {0, 4, 6}, {1, 5, 7}}};
    Sheet whole{connect(std::move(mesh), notes), {}, {}};
    Field number{"number", {}, 1}, place{"place", {}, 3};
    for (const Vec3& p : whole.surface.vertices) {
        number.values.push_back(10 * p.x + p.y);
        place.values.insert(place.values.end(), {p.x, p.y, p.z});
    }
    whole.fields = {number, place};
    const std::uint32_t seed = whole.surface.triangles[3][1];
    whole.sources.vertices = {seed};
    whole.sources.segments = {{1, {9, 0, 0}, {10, 0, 0}}, {2, {0, 0, 0}, {0.5, 0.5, 0}}};
    const auto parts = components(whole);
    ASSERT_EQ(parts.size(), 2U);
    for (std::uint32_t c = 0; c < 2; ++c) {
        const Sheet& own = parts[c].sheet;
        EXPECT_EQ(own.surface.components, 1U);
        EXPECT_EQ(own.surface.rims.size(), 1U);
        EXPECT_EQ(parts[c].triangles, (std::vector<std::uint32_t>{c, c + 2}));
        for (std::size_t t = 0; t < 2; ++t)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(own.surface.vertices[own.surface.triangles[t][k]],
                          whole.surface.vertices[whole.surface.triangles[parts[c].triangles[t]][k]]);
        for (std::size_t v = 0; v < own.surface.vertices.size(); ++v) {
            const Vec3& p = own.surface.vertices[v];
            EXPECT_EQ(own.fields[0].values[v], 10 * p.x + p.y);
            EXPECT_EQ(own.fields[1].vector(v), p);
        }
        ASSERT_EQ(own.sources.segments.size(), 1U);
        EXPECT_EQ(own.sources.segments[0].triangle, c == 0 ? 1U : 0U);
    }
    EXPECT_TRUE(parts[0].sheet.sources.vertices.empty());
    ASSERT_EQ(parts[1].sheet.sources.vertices.size(), 1U);
    EXPECT_EQ(parts[1].sheet.surface.vertices[parts[1].sheet.sources.vertices[0]], whole.surface.vertices[seed]);
}

} // namespace
} // namespace filum::surface
