// Chains end where the tool travels or jumps, and nowhere else.
#include "metrics/surface/fibres.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::Role;
using paths::span;

TEST(Chains, EndAtTravelsAndJumps) {
    const Fibres f = paths::fibres({span({{0, 0, 0}, {1, 0, 0}}), span({{1, 0, 0}, {1, 1, 0}}, 2, Role::hairpin),
                                    span({{1, 1, 0}, {1, 1, 5}, {4, 1, 5}, {4, 1, 0}}, 1, Role::travel),
                                    span({{4, 1, 0}, {5, 1, 0}}), span({{5, 3, 0}, {9, 3, 0}})});
    ASSERT_EQ(f.all.size(), 3);
    EXPECT_DOUBLE_EQ(f.all[0].length(), 2);
    EXPECT_EQ(f.all[0].role[1], Role::hairpin);
    EXPECT_DOUBLE_EQ(f.all[0].width[1], 2);
    EXPECT_DOUBLE_EQ(f.all[2].length(), 4);
    EXPECT_DOUBLE_EQ(f.travel, 5 + 3 + 5 + 2);
    EXPECT_EQ(f.jumps, 1);
    EXPECT_DOUBLE_EQ(length(f), 7);
    EXPECT_DOUBLE_EQ(median_width(f), 1);
}

TEST(Chains, ATravelThatGoesNowhereIsNoCut) {
    const Fibres f = paths::fibres({span({{0, 0, 0}, {1, 0, 0}}), span({{1, 0, 0}, {1, 0, 0}}, 1, Role::travel),
                                    span({{1, 0, 0}, {1, 0, 0}, {2, 0, 0}})});
    ASSERT_EQ(f.all.size(), 1);
    EXPECT_EQ(f.all[0].points.size(), 3);
}

TEST(Chains, AreResampledEvenly) {
    const Fibres f = paths::fibres({span({{0, 0, 0}, {0.1, 0, 0}, {3, 0, 0}, {3, 4.4, 0}})});
    const auto p = resampled(f.all[0], 1);
    ASSERT_EQ(p.size(), 8);
    EXPECT_NEAR(p[1].x, 7.4 / 7, 1e-12);
    EXPECT_NEAR(p[4].y, 4 * 7.4 / 7 - 3, 1e-12);
    EXPECT_EQ(p.back(), (Vec3{3, 4.4, 0}));
}

TEST(Quantiles, AreByWeight) {
    std::vector<Weighted> v{{3, 1}, {1, 8}, {2, 1}};
    EXPECT_EQ(quantile(v, 0), 1);
    EXPECT_EQ(quantile(v, 0.8), 1);
    EXPECT_EQ(quantile(v, 0.85), 2);
    EXPECT_EQ(quantile(v, 1), 3);
    std::vector<Weighted> none;
    EXPECT_TRUE(std::isnan(quantile(none, 0.5)));
}

} // namespace
} // namespace filum::metrics::surface
