#include "metrics/planar/turns.hpp"
#include "metrics/planar/widths.hpp"

#include "toolpaths.hpp"

namespace filum::metrics::planar {

namespace {

Beads beads(const std::vector<toolpath::Span>& spans) {
    Beads out;
    for (const auto& s : spans) add(out, s);
    return out;
}

TEST(Turns, ShareOfTheDiscIsTheAngle) {
    for (const double degrees : {180.0, 120.0, 109.0, 90.0, 45.0, 10.0}) {
        const double a = degrees * std::numbers::pi / 180;
        const std::vector<Vec2> ahead{{0, 0}, {5, 0}}, back{{0, 0}, {5 * std::cos(a), 5 * std::sin(a)}};
        EXPECT_NEAR(disc_share(ahead, back, 1), degrees / 360, 1e-9);
        EXPECT_NEAR(disc_share(back, ahead, 1), degrees / 360, 1e-9);
    }
    const std::vector<Vec2> here{{0, 0}, {0.5, 0}}, far{{0, 0}, {9, 0}};
    EXPECT_EQ(disc_share(here, far, 1), -1);
}

TEST(Turns, OfAStraightLineAreNone) {
    const Turns t = turns(beads({bead({{0, 0, 0}, {50, 20, 0}, {100, 40, 0}})}), 0.4, 1000, 1);
    EXPECT_EQ(t.sharp, 0);
    EXPECT_NEAR(static_cast<double>(t.samples), 1000, 9);
    EXPECT_TRUE(std::isinf(t.min_radius));
}

TEST(Turns, OfACircleDependOnItsRadius) {
    const auto circle = [](double r) {
        std::vector<geom::Vec3> p;
        for (int k = 0; k <= 360; ++k)
            p.push_back({r * std::cos(k * std::numbers::pi / 180), r * std::sin(k * std::numbers::pi / 180), 0});
        return beads({bead(p)});
    };
    EXPECT_EQ(turns(circle(2), 0.4, 1000, 1).sharp, 0);
    EXPECT_NEAR(turns(circle(2), 0.4, 1000, 1).min_radius, 2, 0.02);
    const Turns tight = turns(circle(0.21), 0.4, 1000, 1);
    EXPECT_GT(tight.samples, 100);
    EXPECT_EQ(tight.sharp, tight.samples); // the smaller lens is 0.27 of the disc
    EXPECT_NEAR(tight.min_radius, 0.21, 0.01);
}

TEST(Turns, OfAZigzagAreAtItsEnds) {
    std::vector<geom::Vec3> p;
    for (int k = 0; k < 50; ++k) {
        const double y = 0.4 * k, x = k % 2 == 0 ? 0 : 20;
        p.push_back({x, y, 0});
        p.push_back({20 - x, y, 0});
    }
    const Turns t = turns(beads({bead(p)}), 0.4, 50000, 1);
    // Each end: the way across (0.4) and a stretch on both sides where the disc still reaches around the corner.
    EXPECT_GT(t.share(), 49 * 0.4 / 1020);
    EXPECT_LT(t.share(), 49 * 1.2 / 1020);
    EXPECT_EQ(turns(beads({bead(p)}), 0.4, 50000, 2).sharp, t.sharp);
    EXPECT_NEAR(t.min_radius, 0.2 / std::numbers::sqrt2, 1e-9); // through 0.2 before and after a corner of 90 degrees
}

TEST(Widths, AreSharesOfLength) {
    const Beads b = beads({bead({{0, 0, 0}, {30, 0, 0}}, 0.4), bead({{0, 1, 0}, {10, 1, 0}}, 0.5)});
    const Widths w = widths(b);
    EXPECT_NEAR(w.median, 0.4, 1e-6);
    EXPECT_NEAR(w.mean, (30 * 0.4 + 10 * 0.5) / 40, 1e-6);
    EXPECT_NEAR(w.max, 0.5, 1e-6);
    EXPECT_NEAR(w.bin, 0.05, 1e-9);
    EXPECT_NEAR(w.first, 0.4, 1e-9);
    ASSERT_EQ(w.share.size(), 3);
    EXPECT_NEAR(w.share[0], 0.75, 1e-6);
    EXPECT_NEAR(w.share[2], 0.25, 1e-6);
    EXPECT_TRUE(widths(Beads{}).share.empty());
}

TEST(Widths, TooManyBinsEndOpen) {
    const Beads b = beads({bead({{0, 0, 0}, {100, 0, 0}}, 0.4), bead({{0, 1, 0}, {1, 1, 0}}, 1000)});
    const Widths w = widths(b);
    EXPECT_EQ(w.share.size(), 64);
    EXPECT_NEAR(w.share.back(), 1.0 / 101, 1e-6);
}

TEST(SeamDistances, AreBetweenARegionAndThoseBelow) {
    std::vector<polygon::Region> r{region(0, 0, box(0, 0, 5, 5)), region(1, 0, box(10, 0, 15, 5)),
                                   region(2, 1, box(0, 0, 5, 5))};
    r[2].below = {{0, 25, 2.5}};
    Beads b;
    b.marks = layer_marks(r);
    add(b, bead({{1, 1, 0.2}, {4, 1, 0.2}}, 0.4, 0.2, 0, 0));
    add(b, travel({4, 1, 0.2}, {11, 1, 0.2}));
    add(b, bead({{11, 1, 0.2}, {14, 1, 0.2}}, 0.4, 0.2, 0, 1));
    add(b, travel({14, 1, 0.2}, {4, 5, 0.4}));
    add(b, bead({{4, 5, 0.4}, {1, 5, 0.4}}, 0.4, 0.2, 1, 2));
    const SeamDistances s = seams(b, r, 0.4);
    EXPECT_EQ(s.pairs, 1);
    EXPECT_NEAR(s.mean, 5, 1e-12);
    EXPECT_EQ(s.near, 0);
    EXPECT_NEAR(seams(b, {}, 2).min, 5, 1e-12); // the nearest start below
    EXPECT_EQ(seams(b, {}, 2).near, 1);
}

TEST(Beads, BelongToTheLayerTheyLieIn) {
    Beads b;
    b.marks = layer_marks({region(0, 0, box(0, 0, 5, 5)), region(1, 1, box(0, 0, 5, 5))});
    add(b, bead({{0, 0, 0.2}, {1, 0, 0.2}, {2, 0, 0.4}, {3, 0, 0.4}, {4, 0, 0.9}}, 0.4, 0.2, 7)); // claims layer 7
    ASSERT_EQ(b.layer.size(), 2);
    EXPECT_EQ(b.layer[0].points.size(), 2);
    EXPECT_EQ(b.layer[1].points.size(), 4); // a ramp belongs to what it is in; the part above the top is counted there
    EXPECT_EQ(b.misplaced, 1);
}

TEST(Beads, AreAsWideAsTheyAreLaidAndAsThick) {
    Beads b;
    b.marks = layer_marks({region(0, 0, box(0, 0, 5, 5))});
    add(b, bead({{0, 0, 0.2}, {1, 0, 0.2}}, 0.4, 0.2));
    add(b, bead({{2, 0, 0.1}, {3, 0, 0.1}}, 0.4, 0.1)); // half as high as its layer
    add(b, bead({{4, 0, 0.2}, {5, 0, 0.2}}, 0.4, 0.2));
    const LayerBeads& l = b.layer[0];
    for (const std::size_t i : {0, 2, 4}) EXPECT_NEAR(l.width[i], 0.4, 1e-7);
    EXPECT_EQ(l.thickness(0), 1);
    EXPECT_NEAR(l.thickness(2), 0.5, 1e-7);
    EXPECT_EQ(l.thickness(4), 1);
}

// A helix of many points rises by less than a thousandth of a layer from one to the next.
TEST(Beads, ThatRiseBelongToTheLayerAbove) {
    Beads b;
    b.marks = layer_marks({region(0, 0, box(0, 0, 5, 5)), region(1, 1, box(0, 0, 5, 5))});
    add(b, bead({{0, 0, 0.2}, {1, 0, 0.2 + 1e-5}, {2, 0, 0.2 + 2e-5}}, 0.4, 0.2));
    add(b, bead({{0, 1, 0.2 + 1e-5}, {1, 1, 0.2 + 1e-5}}, 0.4, 0.2)); // level, and rounded
    EXPECT_EQ(b.layer[1].points.size(), 3U);
    EXPECT_EQ(b.layer[0].points.size(), 2U);
    ASSERT_EQ(b.layer[1].z.size(), 3U);
    EXPECT_NEAR(b.layer[1].z[2], 0.2 + 2e-5, 1e-7);
    EXPECT_TRUE(b.layer[0].z.empty());
}

} // namespace

} // namespace filum::metrics::planar
