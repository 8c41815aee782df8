#include "render/hidden.hpp"

#include <gtest/gtest.h>

namespace filum::render {

namespace {

// Lines along x, `pitch` apart, that make a block of 8 x 8 x 2 mm at `at`.
Scene block(double pitch, geom::Vec3 at) {
    Scene s;
    for (std::uint32_t layer = 0; layer < 10; ++layer)
        for (double y = 0; y < 8; y += pitch) {
            const double z = 0.2 * (layer + 1);
            s.spans.push_back({toolpath::Role::bead,
                               0,
                               layer,
                               0,
                               {at + geom::Vec3{0, y, z}, at + geom::Vec3{8, y, z}},
                               {0.4},
                               {0.2}});
        }
    return s;
}

TEST(HiddenBeads, IsTheInsideOfABlock) {
    for (const geom::Vec3 at : {geom::Vec3{}, geom::Vec3{-1e4, 1e5, 7}}) {
        const HiddenBeads hidden(block(0.4, at), 0.4, 0.2);
        EXPECT_TRUE(hidden(at + geom::Vec3{2, 4, 1}, at + geom::Vec3{6, 4, 1}));
        EXPECT_FALSE(hidden(at + geom::Vec3{0, 4, 1}, at + geom::Vec3{8, 4, 1})); // comes out at both ends
        EXPECT_FALSE(hidden(at + geom::Vec3{2, 4, 2}, at + geom::Vec3{6, 4, 2})); // the top
        EXPECT_FALSE(hidden(at + geom::Vec3{2, 4, 0.2}, at + geom::Vec3{6, 4, 0.2}));
        EXPECT_FALSE(hidden(at + geom::Vec3{2, 0, 1}, at + geom::Vec3{6, 0, 1})); // a side
    }
}

TEST(HiddenBeads, IsNothingBetweenGaps) {
    const HiddenBeads hidden(block(1.2, {}), 0.4, 0.2);
    for (double y = 0; y < 8; y += 1.2) EXPECT_FALSE(hidden({2, y, 1}, {6, y, 1}));
}

TEST(HiddenBeads, IsNothingInAnEmptyOrEndlessScene) {
    EXPECT_FALSE(HiddenBeads({}, 0.4, 0.2)({0, 0, 0}, {1, 0, 0}));
    Scene far = block(0.4, {});
    far.spans.push_back({toolpath::Role::bead, 0, 0, 0, {{1e8, 1e8, 1e8}, {1e8, 1e8, 1e8 - 1}}, {0.4}, {0.2}});
    EXPECT_FALSE(HiddenBeads(far, 0.4, 0.2)({2, 4, 1}, {6, 4, 1}));
}

} // namespace

} // namespace filum::render
