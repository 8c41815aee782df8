#include "stacks.hpp"

namespace filum::link3d {

using namespace test;

// Steep nowhere, down never, as much material as without, and nothing but ramps between layers.
TEST(Ramp, RisesGentlyAndLaysTheSame) {
    Random random{11};
    for (const Curve& plain : {comb({0, 0}, 9, 16), rings({4, 4}, 4, 9)}) {
        for (const Curve& c : {plain, refined(plain, 0.35, random)}) {
            const auto regions = column(std::vector<std::vector<Curve>>(12, {c}));
            Options o;
            o.lift = Lift::ramp;
            const auto r = link(regions, o);
            check(regions, r);
            EXPECT_EQ(r.counts.strokes, 1U);
            EXPECT_EQ(r.counts.ramps, 11U);
            double rising = 0;
            for (const auto& s : r.spans) {
                for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
                    const double up = s.points[i + 1].z - s.points[i].z;
                    const double along = geom::distance(s.points[i].xy(), s.points[i + 1].xy());
                    EXPECT_GE(up, 0);
                    EXPECT_LE(up, along / 20 + 1e-9);
                    EXPECT_GT(s.height_at(i), 0);
                    EXPECT_LE(s.height_at(i), kHeight + 1e-12);
                    rising += up;
                }
            }
            EXPECT_NEAR(rising, 11 * kHeight, 1e-9);
            const double none = volume(link(regions), false);
            EXPECT_NEAR(volume(r, false), none, 0.003 * none);
        }
    }
}

// Over its beginning a bead is as thick as what is missing there.
TEST(Ramp, EndsWithItsComplement) {
    const Curve c = comb({0, 0}, 9, 16);
    const SegmentIndex index(std::span(&c, 1));
    const Place at = *index.nearest({4, 0});
    const Ramp ramp{4, 0.5, 0.2};
    const Bead bead = cut_over(c, at, false, 3.5);
    const SpatialBead laid = lay(bead, 0.4, 0.2, ramp, 0.2);
    const double all = length(bead.points);
    double s = 0;
    int rising = 0, over = 0;
    for (std::size_t i = 0; i < laid.points.size(); ++i) {
        if (i > 0) s += geom::distance(laid.points[i - 1].xy(), laid.points[i].xy());
        if (s < 3.3) {
            ++rising;
            EXPECT_NEAR(laid.height[i], 0.2 * (0.5 + s) / 4, 1e-9);
            EXPECT_NEAR(laid.points[i].z, 0.2 + laid.height[i], 1e-9) << "it lies on the layer below";
        } else if (s > all - 3.3) {
            ++over;
            EXPECT_NEAR(laid.height[i], 0.2 * std::max(0.05, 1 - (0.5 + s - all + 3.5) / 4), 1e-9);
            EXPECT_NEAR(laid.points[i].z, 0.4, 1e-9);
        } else if (s > 3.6 && s < all - 3.6) {
            EXPECT_EQ(laid.height[i], 0.2);
            EXPECT_NEAR(laid.points[i].z, 0.4, 1e-9);
        }
    }
    EXPECT_GE(rising, 17);
    EXPECT_GE(over, 17);
}

TEST(Ramp, ShortCurvesAreClimbedPlainly) {
    const auto regions = column(std::vector<std::vector<Curve>>(4, {circle({0, 0}, 0.5, 40)}));
    Options o;
    o.lift = Lift::ramp;
    const auto r = link(regions, o);
    check(regions, r);
    EXPECT_EQ(r.counts.ramps, 0U);
    EXPECT_EQ(r.counts.lifts, 3U);
}

// A prism winds up in one even slope between a flat first layer and a flat last turn.
TEST(Helix, WindsEvenlyWhereLayersAreAlike) {
    for (const Curve& c : {comb({0, 0}, 9, 16), rings({4, 4}, 4, 9), circle({0, 0}, 5, 90)}) {
        const auto regions = column(std::vector<std::vector<Curve>>(12, {c}));
        Options o;
        o.lift = Lift::helical;
        const auto r = link(regions, o);
        EXPECT_EQ(r.counts.strokes, 1U);
        EXPECT_EQ(r.counts.turns, 11U);
        EXPECT_EQ(r.counts.breaks + r.counts.ramps, 0U);
        const double around = length(c.points) + geom::distance(c.points.back(), c.points.front());
        for (std::size_t k = 0; k < r.spans.size(); ++k) {
            const Span& s = r.spans[k];
            if (k > 0) {
                EXPECT_EQ(s.points.front(), r.spans[k - 1].points.back());
            }
            for (std::size_t i = 0; i + 1 < s.points.size(); ++i) {
                const double up = s.points[i + 1].z - s.points[i].z;
                const double along = geom::distance(s.points[i].xy(), s.points[i + 1].xy());
                EXPECT_GE(up, 0);
                EXPECT_LE(up, kHeight / around * along + 1e-9);
                if (s.layer > 1 && s.layer < 11) {
                    EXPECT_NEAR(s.height_at(i), kHeight, 0.01 * kHeight);
                }
            }
        }
        const double none = volume(link(regions), false);
        EXPECT_NEAR(volume(r, false), none, 0.01 * none);
    }
}

// The jog to a first turn lies on the layer below, across its beads: as thin as a ramp begins.
TEST(Helix, IsEnteredByAThinJogThatRises) {
    std::vector<std::vector<Curve>> layers{{comb({0, 0}, 9, 16)}};
    for (int i = 0; i < 6; ++i) layers.push_back({comb({0.15, 0.1}, 9, 16)});
    Options o;
    o.lift = Lift::helical;
    const auto r = link(column(layers), o);
    EXPECT_GT(r.counts.turns, 4U);
    std::size_t jogs = 0;
    for (const Span& s : r.spans) {
        if (s.role != Role::lift || s.points.front().xy() == s.points.back().xy()) continue;
        ++jogs;
        EXPECT_NEAR(s.points.back().z - s.points.front().z, kFaint * kHeight, 1e-9);
        EXPECT_NEAR(s.height_at(0), kFaint * kHeight, 1e-9);
    }
    EXPECT_GT(jogs, 0U);
}

// Layers of other shapes cannot wind: they are climbed by ramps.
TEST(Helix, FallsBackToRamps) {
    std::vector<std::vector<Curve>> layers;
    for (int i = 0; i < 8; ++i) layers.push_back({i % 2 == 0 ? comb({0, 0}, 9, 16) : rings({4, 3}, 3.2, 8)});
    const auto regions = column(layers);
    Options o;
    o.lift = Lift::helical;
    const auto r = link(regions, o);
    check(regions, r);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.turns, 0U);
    EXPECT_EQ(r.counts.ramps, 7U);
}

} // namespace filum::link3d
