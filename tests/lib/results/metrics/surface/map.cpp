// Maps whose values are known.
#include "metrics/surface/map.hpp"

#include "metrics/surface/map_figures.hpp"
#include "metrics/surface/map_sheet.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::span;
using paths::Vec2;

Surface square() { return surfaces::sheet(20, 20, 20, 20, 7).surface; }

// Beads along x over a plate of 20 x 20 mm at these y, of one layer, `z` above it.
std::vector<toolpath::Span> rows(const std::vector<double>& at, std::uint32_t layer, double z, double lean = 0) {
    std::vector<toolpath::Span> out;
    for (const double y : at) {
        auto s = span({{0, y, z}, {20, y + 20 * lean, z}});
        s.layer = layer;
        s.normals = {{0, 0, 1}, {0, 0, 1}};
        out.push_back(s);
    }
    return out;
}

std::vector<double> every(double from, double step, int n) {
    std::vector<double> out;
    for (int i = 0; i < n; ++i) out.push_back(from + i * step);
    return out;
}

TEST(Map, CountsBeadsPointByPoint) {
    const auto base = square();
    auto at = every(0.5, 1, 20);
    at.erase(at.begin() + 10); // no bead from y = 10 to 11
    at.push_back(5.5);         // twice from 5 to 6
    const auto path = paths::fibres(rows(at, 0, 0));
    const auto made = map(base, path, beds(base, path, 1), 1);
    const auto ply = ply_spread(made, 0);
    EXPECT_NEAR(ply.bare, 0.05, 0.002);
    EXPECT_NEAR(ply.twice, 0.05, 0.002);
    EXPECT_EQ(ply.thrice, 0);
    EXPECT_NEAR(ply.gap_most, 0.5, 0.1);
    EXPECT_NEAR(ply.gap_at.y, 10.5, 0.1);
    EXPECT_NEAR(ply.over_most, 1, 0.01);
    EXPECT_NEAR(ply.over_at.y, 5.5, 0.5);
    EXPECT_NEAR(spread_of(made, made.thickness).mean, 0.2, 0.0015);
    EXPECT_TRUE(std::isnan(ply.off_median)); // nothing is asked
}

// Beads side by side, the outermost along the rims, for any triangles: one bead at every point. Points inside
// that are nearer to a rim than a sixth of a width miss a part, less than half.
TEST(Map, ARimIsCoveredByTheBeadAlongIt) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Surface base = surfaces::sheet(20, 20, 20, 20, seed).surface;
        const auto path = paths::fibres(rows(every(0.5, 1, 20), 0, 0));
        const auto made = map(base, path, beds(base, path, 1), 1);
        const Surface& s = made.ground.surface;
        for (std::uint32_t v = 0; v < made.area.size(); ++v)
            EXPECT_NEAR(made.plies[0].passes[v], 1, s.on_rim(v) ? 1e-6 : 0.5) << seed;
        EXPECT_NEAR(spread_of(made, made.thickness).mean, 0.2, 2e-4) << seed;
        const auto rim_gap = map(base, paths::fibres(rows(every(1.5, 1, 18), 0, 0)), beds(base, path, 1), 1);
        EXPECT_NEAR(ply_spread(rim_gap, 0).bare, 0.1, 0.003) << seed; // without the outermost beads
        EXPECT_NEAR(ply_spread(rim_gap, 0).gap_most, 1, 1e-6) << seed;
    }
}

// The same with beads of two widths: a point's area does not depend on the bead over it.
TEST(Map, ARimIsCoveredByAWideBeadBesideNarrowOnes) {
    for (const double wide : {1.0, 1.3, 1.6}) {
        const Surface base = square();
        auto along = rows({wide / 2, 20 - wide / 2}, 0, 0);
        const double rest = (20 - 2 * wide) / 24;
        const auto inner = rows(every(wide + rest / 2, rest, 24), 0, 0);
        for (auto& s : along) s.width = {wide};
        along.insert(along.end(), inner.begin(), inner.end());
        for (std::size_t i = 2; i < along.size(); ++i) along[i].width = {rest};
        const auto path = paths::fibres(along);
        const auto made = map(base, path, beds(base, path, 1), 1);
        for (std::uint32_t v = 0; v < made.area.size(); ++v) {
            if (!made.ground.surface.on_rim(v)) continue;
            EXPECT_NEAR(made.plies[0].passes[v], 1, 1e-6) << wide;
        }
        EXPECT_NEAR(ply_spread(made, 0).bare, 0, 1e-3) << wide;
        EXPECT_NEAR(spread_of(made, made.thickness).mean, 0.2, 1e-3) << wide;
    }
}

// For any limit a map gets as few points as needed, down to those of the surface, with values that it has there.
TEST(Map, HasFewerPointsWhereItWouldBeTooLarge) {
    for (unsigned seed = 1; seed <= 2; ++seed) {
        const Surface base = surfaces::sheet(20, 20, 5, 5, seed).surface;
        const auto path = paths::fibres(rows(every(0.5, 1, 20), 0, 0));
        const auto whole = sheet_of(map(base, path, beds(base, path, 1), 1), "A");
        std::size_t before = whole.surface.vertices.size();
        for (std::size_t most = 1 << 18; most > 512; most /= 4) {
            const auto made = within_size(whole, base, most);
            const std::size_t n = made.surface.vertices.size();
            EXPECT_LE(n, before);
            EXPECT_TRUE(n == base.vertices.size() || 8 * n * (3 + made.fields.size()) <= most);
            EXPECT_NEAR(filum::surface::area(made.surface), filum::surface::area(base), 1e-6);
            EXPECT_EQ(made.name, "A");
            ASSERT_EQ(made.fields.size(), whole.fields.size());
            std::size_t found = 0; // points that the whole map has, too: its values there, to the bit
            for (std::size_t v = 0; v < n; ++v) {
                std::size_t near = 0;
                for (std::size_t w = 0; w < whole.surface.vertices.size(); ++w)
                    if (distance(whole.surface.vertices[w], made.surface.vertices[v]) <
                        distance(whole.surface.vertices[near], made.surface.vertices[v]))
                        near = w;
                const bool same = distance(whole.surface.vertices[near], made.surface.vertices[v]) < 1e-9;
                found += same ? 1 : 0;
                for (std::size_t f = 0; f < made.fields.size(); ++f) {
                    EXPECT_EQ(made.fields[f].name, whole.fields[f].name);
                    ASSERT_EQ(made.fields[f].values.size(), n);
                    if (same) {
                        EXPECT_EQ(made.fields[f].values[v], whole.fields[f].values[near]);
                    }
                }
            }
            EXPECT_GE(10 * found, 9 * n);
            before = n;
        }
        EXPECT_EQ(before, base.vertices.size());
    }
}

TEST(Map, TellsAnglesOfWhatIsAsked) {
    const auto base = square();
    const double lean = std::tan(0.1);
    const auto path = paths::fibres(rows(every(0.5, 1, 18), 0, 0, lean));
    auto lies = beds(base, path, 1);
    lies[0].asked.reference = {1, 0, 0.5}; // laid onto the plate
    const double degree = 180 / std::numbers::pi;
    EXPECT_NEAR(ply_spread(map(base, path, lies, 1), 0).off_median, 0.1 * degree, 1e-6);
    lies[0].asked.turn = 0.1;
    EXPECT_NEAR(ply_spread(map(base, path, lies, 1), 0).off_high, 0, 1e-5);
    filum::surface::Field across{"direction", {}, 3};
    for (std::size_t v = 0; v < base.vertices.size(); ++v)
        across.values.insert(across.values.end(), {0, v % 2 == 0 ? 1.0 : -1.0, 0});
    lies[0].asked = {{}, 0, &across};
    EXPECT_NEAR(ply_spread(map(base, path, lies, 1), 0).off_mean, 90 - 0.1 * degree, 1e-6);
}

TEST(Map, IsNotRaisedToWhatLiesBesideARim) {
    // The first triangle at the corner (20, 20) has no side on the rim; the path passes outside of that corner.
    const Surface base = surfaces::make({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {12, 8, 0}, {8, 12, 0}},
                                        {{4, 2, 5}, {1, 2, 4}, {5, 2, 3}, {0, 1, 4}, {0, 4, 5}, {0, 5, 3}});
    auto spans = rows(every(0.5, 1, 20), 0, 0);
    auto out = span({{20, 20, 0}, {24, 24, 0}, {23, 25, 0}, {20, 20, 0}});
    out.normals.assign(4, {0, 0, 1});
    spans.push_back(out);
    for (const auto& bed : beds(base, paths::fibres(spans), 1))
        for (std::size_t v = 0; v < base.vertices.size(); ++v)
            EXPECT_LT(distance(bed.ground.vertices[v], base.vertices[v]), 0.06) << v;
}

TEST(Map, FindsWhereAPlyLies) {
    const auto base = square();
    auto spans = rows(every(0.5, 1, 20), 0, 0);
    auto step = rows(every(0.5, 1, 10), 1, 0.2); // half of the plate
    spans.insert(spans.end(), step.begin(), step.end());
    for (const double y : every(0.5, 1, 20)) { // over both: it steps down by one ply
        auto s = rows({y}, 2, y < 10 ? 0.4 : 0.2).front();
        spans.push_back(s);
    }
    auto under = rows(every(0.5, 1, 20), 3, -0.3);
    for (auto& s : under) s.normals = {{0, 0, -1}, {0, 0, -1}};
    spans.insert(spans.end(), under.begin(), under.end());
    const auto path = paths::fibres(spans);
    auto lies = beds(base, path, 1);
    ASSERT_EQ(lies.size(), 4U);
    for (std::size_t v = 0; v < base.vertices.size(); ++v) {
        const Vec3& p = base.vertices[v];
        if (std::abs(p.y - 10) < 1.1) continue;
        EXPECT_NEAR(lies[2].ground.vertices[v].z, p.y < 10 ? 0.4 : 0.2, 1e-9);
        EXPECT_NEAR(lies[3].ground.vertices[v].z, -0.3, 1e-9);
    }
    for (const Vec3& p : base.vertices) lies[1].edge.push_back(p.y - 10);
    const auto made = map(base, path, lies, 1);
    EXPECT_LT(ply_spread(made, 1).bare, 0.03); // not where it is not to lie
    for (std::size_t v = 0; v < made.thickness.size(); ++v) {
        const double y = made.ground.surface.vertices[v].y;
        if (std::abs(y - 10) < 2.1 || y < 0.2 || y > 19.8) continue;
        EXPECT_NEAR(made.thickness[v], y < 10 ? 0.8 : 0.6, 1e-9) << y;
        EXPECT_NEAR(made.nominal[v], y < 10 ? 0.8 : 0.6, 1e-9) << y;
    }
    const auto again = map(base, path, lies, 8);
    EXPECT_EQ(again.thickness, made.thickness);
    EXPECT_EQ(again.even, made.even);
}

} // namespace
} // namespace filum::metrics::surface
