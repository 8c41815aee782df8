#include "regions/farthest.hpp"

#include "shapes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace filum::regions {
namespace {

TEST(Farthest, LimitsOfAnySizeAreUsedAsTheyAre) {
    polygon::Region under;
    under.loops = box(0, 0, 10, 10);
    const polygon::Loops area = box(0, 0, 14, 10);
    for (const double least : {0.0, 1.0, 3.9}) {
        const auto far = farthest(area, std::span(&under, 1), least, 0.1);
        ASSERT_TRUE(far) << least;
        EXPECT_NEAR(far->reach, 4, 0.1);
    }
    for (const double least : {4.0, 13.9, 1e9, 1e300, std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(farthest(area, std::span(&under, 1), least, 0.1)) << least;
}

} // namespace
} // namespace filum::regions
