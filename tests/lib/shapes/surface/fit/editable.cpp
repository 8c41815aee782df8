// After any splits, collapses and flips: sides, fans and facing stay as a surface has them.
#include "surface/fit/editable.hpp"
#include "surface/fit/sizes.hpp"

#include "../../../trials.hpp"
#include "../grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::surface::fit {
namespace {

// What a surface promises, asked of each half-edge and each vertex.
void expect_sound(const Editable& m) {
    for (std::uint32_t h = 0; h < m.twin.size(); ++h) {
        if (m.gone(h)) continue;
        ASSERT_EQ(m.out[m.tail(h)] == kNone, false);
        const std::uint32_t g = m.twin[h];
        if (g == kNone) continue;
        ASSERT_FALSE(m.gone(g));
        ASSERT_EQ(m.twin[g], h);
        ASSERT_EQ(m.tail(g), m.head(h));
        ASSERT_EQ(m.head(g), m.tail(h));
        ASSERT_EQ(m.line[g], m.line[h]);
    }
    for (std::uint32_t v = 0; v < m.out.size(); ++v) {
        if (m.out[v] == kNone) continue;
        ASSERT_FALSE(m.gone(m.out[v]));
        ASSERT_EQ(m.tail(m.out[v]), v);
        std::size_t lines = 0;
        each_leaving(m, v, [&](std::uint32_t h) { lines += m.line[h] != 0 ? 1U : 0U; });
        if (m.kind[v] == VertexKind::free) {
            ASSERT_EQ(lines, 0U);
        }
    }
}

Surface hill(int n, bool holed) {
    Notes notes;
    const auto lift = [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, std::sin(p.x) * std::cos(0.7 * p.y)}; };
    return connect(pierced_grid(6, 5, n, n, lift,
                                [&](geom::Vec2 p) {
                                    return holed && norm(p - geom::Vec2{3, 2.5}) < 1;
                                }),
                   notes);
}

TEST(Editable, StaysSoundUnderAnyChanges) {
    for (int round = 0; round < trials(40); ++round) {
        std::mt19937 random(static_cast<unsigned>(round));
        const Surface s = hill(3 + round % 6, round % 2 == 0);
        Editable m = editable(s, std::vector<double>(s.vertices.size(), 1), 0.02);
        const auto any = [](std::uint32_t, std::uint32_t) { return 100.0; };
        std::size_t done[3] = {0, 0, 0};
        for (int step = 0; step < 400; ++step) {
            const auto h = static_cast<std::uint32_t>(random() % m.twin.size());
            if (m.gone(h)) continue;
            const auto what = random() % 5;
            if (what == 0) {
                split(m, h);
                ++done[0];
            } else if (what < 3 && collapsible(m, h, any)) {
                collapse(m, h);
                ++done[1];
            } else if (what >= 3 && flippable(m, h)) {
                flip(m, h);
                ++done[2];
            }
            if (step % 20 == 0) expect_sound(m);
            if (HasFatalFailure()) return;
        }
        for (const std::size_t n : done) EXPECT_GT(n, 0U);
        const Surface out = compact(m); // which checks that it is one
        EXPECT_EQ(out.rims.size(), s.rims.size());
        EXPECT_EQ(out.components, 1U);
    }
}

TEST(Editable, NothingTurnsOver) {
    const auto fan = [](const Vec3& top) {
        Notes notes;
        mesh::Mesh m;
        m.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, top};
        for (std::uint32_t k = 0; k < 4; ++k) m.triangles.push_back({k, (k + 1) % 4, 4});
        const Surface s = connect(m, notes);
        return editable(s, std::vector<double>(5, 1), 0.02);
    };
    const Editable m = fan({2, 2, 0});
    EXPECT_TRUE(may_move(m, 4, {3, 3.2, 0}));
    EXPECT_TRUE(may_move(m, 4, {2, 2, 0.5}));
    EXPECT_FALSE(may_move(m, 4, {5, 2, 0}));    // beyond a side
    EXPECT_FALSE(may_move(m, 4, {3.99, 2, 0})); // next to it: thin
    EXPECT_FALSE(may_move(m, 4, {2, 2, 9}));    // up like a spire
}

TEST(Editable, LinesAndRimsAreNotLost) {
    Notes notes;
    const auto roof = [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, p.x < 2 ? p.x : 4 - p.x}; };
    const Surface s = connect(grid(4, 4, 4, 4, roof), notes);
    Editable m = editable(s, std::vector<double>(s.vertices.size(), 10), 0.02);
    const auto any = [](std::uint32_t, std::uint32_t) { return 100.0; };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t h = 0; h < m.twin.size(); ++h)
            if (!m.gone(h) && collapsible(m, h, any)) {
                collapse(m, h);
                changed = true;
            }
    }
    const Surface out = compact(m);
    EXPECT_EQ(out.triangles.size(), 4U); // two halves of a roof, in two each
    EXPECT_NEAR(area(out), area(s), 1e-9);
}

TEST(Sizes, GrowNoFasterThanHalfTheWay) {
    const Surface s = hill(20, true);
    const auto wanted = sizes(s, 2, 0.001).wanted;
    double least = 2, most = 0;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        EXPECT_LT(wanted[s.head(h)], wanted[s.tail(h)] + 0.5 * side_length(s, h) + 1e-12);
        least = std::min(least, wanted[s.tail(h)]);
        most = std::max(most, wanted[s.tail(h)]);
    }
    EXPECT_LT(least, 0.7 * most);
}

} // namespace
} // namespace filum::surface::fit
