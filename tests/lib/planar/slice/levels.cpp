// Which layers a part gets.
#include "../../shapes/mesh/shapes.hpp"
#include "base/error.hpp"
#include "slice/slice.hpp"

#include <gtest/gtest.h>

using namespace filum;
using slice::Level;
using slice::Options;

namespace {

std::vector<Level> of_height(double height, const Options& o, Notes& notes) {
    return slice::levels(shapes::box({0, 0, 1}, {1, 1, 1 + height}), o, notes);
}

} // namespace

TEST(Levels, AsManyAsComeNearest) {
    for (const auto& [height, count] :
         {std::pair{3.0, 15U}, std::pair{3.09, 15U}, std::pair{3.1, 15U}, std::pair{3.11, 16U}, std::pair{48.0, 240U},
          std::pair{0.2, 1U}, std::pair{0.29, 1U}}) {
        Notes notes;
        const auto l = of_height(height, {}, notes);
        ASSERT_EQ(l.size(), count) << height;
        EXPECT_TRUE(notes.empty());
        for (std::size_t i = 0; i < l.size(); ++i) {
            EXPECT_NEAR(l[i].z, 1 + 0.2 * static_cast<double>(i + 1), 1e-9);
            EXPECT_NEAR(l[i].plane, l[i].z - 0.1, 1e-9);
            EXPECT_LE(l[i].plane, 1 + height + 1e-12);
        }
    }
}

TEST(Levels, TheFirstMayDiffer) {
    Notes notes;
    const auto l = of_height(3, {.layer_height = 0.2, .first_layer_height = 0.4}, notes);
    ASSERT_EQ(l.size(), 14U);
    EXPECT_NEAR(l[0].z, 1.4, 1e-12);
    EXPECT_NEAR(l[0].height, 0.4, 1e-12);
    EXPECT_NEAR(l[13].z, 4, 1e-9);
}

TEST(Levels, LowParts) {
    Notes notes;
    const auto l = of_height(0.13, {}, notes);
    ASSERT_EQ(l.size(), 1U);
    EXPECT_EQ(notes.size(), 1U);
    EXPECT_NEAR(l[0].plane, 1.065, 1e-12);
    EXPECT_THROW(of_height(0.09, {}, notes), Error);
    EXPECT_THROW(of_height(0, {}, notes), Error);
}

TEST(Levels, TooManyEndClearly) {
    Notes notes;
    EXPECT_THROW(of_height(1e6, {.layer_height = 0.001}, notes), Error);
    EXPECT_THROW(of_height(1e6, {.adaptive = true, .min_layer_height = 0.001}, notes), Error);
}

TEST(Levels, AdaptiveOnesFollowTheSlope) {
    const auto sphere = shapes::sphere(10, 5);
    const Options o{.adaptive = true, .min_layer_height = 0.08, .max_layer_height = 0.32, .cusp = 0.1};
    Notes notes;
    const auto l = slice::levels(sphere, o, notes);
    EXPECT_NEAR(l.back().z, 10, 0.04);
    double z = -10;
    for (std::size_t i = 0; i < l.size(); ++i) {
        EXPECT_NEAR(l[i].z - l[i].height, z, 1e-9); // no gap, no overlap
        EXPECT_GT(l[i].plane, z);
        EXPECT_LT(l[i].plane, l[i].z);
        z = l[i].z;
        if (i == 0) continue;
        EXPECT_GE(l[i].height, 0.08 - 1e-9);
        EXPECT_LE(l[i].height, 0.32 + 1e-9);
        if (i > 1) {
            EXPECT_LT(std::abs(l[i].height - l[i - 1].height), 0.34 * std::max(l[i].height, l[i - 1].height)) << i;
        }
        const double steepest = std::max(std::abs(l[i].z), std::abs(l[i].z - l[i].height)) / 10; // n_z of a sphere
        EXPECT_LT(l[i].height * std::min(1.0, steepest), std::max(0.1, 0.08) * 1.15);
    }
    EXPECT_LT(l[l.size() - 2].height, 0.14); // thin at the pole
    EXPECT_GT(l[l.size() / 2].height, 0.3);  // thick at the equator
}

TEST(Levels, AdaptiveOnesOfUprightWallsAreThick) {
    Notes notes;
    shapes::Mesh tube = shapes::box({0, 0, 0}, {5, 5, 9});
    tube.triangles.erase(tube.triangles.begin(), tube.triangles.begin() + 4); // no bottom, no top
    for (const auto& l : slice::levels(tube, {.adaptive = true, .max_layer_height = 0.3}, notes))
        EXPECT_GE(l.height, 0.2 - 1e-9);
    EXPECT_THROW(slice::levels(tube, {.adaptive = true, .min_layer_height = 0.4, .max_layer_height = 0.3}, notes),
                 Error);
}
