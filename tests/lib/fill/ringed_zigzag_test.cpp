#include "fill/ringed_zigzag.hpp"

#include "pattern_check.hpp"

namespace filum::fill {
namespace {

using namespace test;

TEST(RingedZigzag, LinkedIsOneClosedCurveThatNeverCrossesItself) {
    const auto check = [](const Loops& region, int rings, double angle, const std::string& name) {
        Notes notes;
        const auto curves = ringed_zigzag(region, {.angle = angle, .rings = rings}, notes);
        expect_sound(curves);
        ASSERT_EQ(curves.size(), 1U) << name;
        EXPECT_TRUE(curves[0].closed);
        EXPECT_EQ(crossings(curves), 0U) << name;
        EXPECT_LT(farthest_outside(region, curves), 0.12) << name; // acute tips may be moved a little
    };
    for (const auto& [name, region] : hard_regions())
        for (const int rings : {1, 2, 4}) check(region, rings, 0.3, name);
    for (unsigned seed = 0; seed < 15; ++seed)
        for (const auto& region : random_regions(seed))
            if (polygon::signed_area(region) > 0.5) check(region, 2, 0.1 * seed, std::to_string(seed));
}

TEST(RingedZigzag, LaysTheRegionsArea) {
    for (const auto& [name, region] : hard_regions())
        for (const bool linked : {true, false}) {
            Notes notes;
            const auto curves = ringed_zigzag(region, {.angle = 0.5, .linked = linked}, notes);
            EXPECT_EQ(crossings(curves), 0U) << name;
            EXPECT_NEAR(laid(curves) / polygon::signed_area(region), 1, 0.12) << name; // acute tips are overfilled
            EXPECT_GT(coverage(region, curves), 0.94) << name;
        }
}

TEST(RingedZigzag, UnlinkedIsRingsAndOneCore) {
    Notes notes;
    const auto region = rectangle(0, 0, 12, 8);
    const auto curves = ringed_zigzag(region, {.rings = 3, .linked = false}, notes);
    ASSERT_EQ(curves.size(), 4U);
    for (int k = 0; k < 3; ++k)
        for (const Vec2 p : curves[static_cast<std::size_t>(k)].points)
            EXPECT_NEAR(distance_to_outline(region, p), (k + 0.5) * 0.4, 0.02);
    for (const Vec2 p : curves[3].points) EXPECT_GT(distance_to_outline(region, p), 3.4 * 0.4);
}

TEST(RingedZigzag, CoreRunsAtTheAngle) {
    const double angle = 0.7;
    const Vec2 d{std::cos(angle), std::sin(angle)};
    Notes notes;
    const auto core = ringed_zigzag(disc({0, 0}, 9), {.angle = angle, .linked = false}, notes).back();
    double along = 0;
    for (std::size_t i = 0; i < core.points.size(); ++i) {
        const Vec2 s = core.points[(i + 1) % core.points.size()] - core.points[i];
        if (std::abs(geom::cross(s, d)) < 0.05 * geom::norm(s)) along += geom::norm(s);
    }
    EXPECT_GT(along, 0.75 * length_of(core));
}

TEST(RingedZigzag, TakesWhateverIsTooSmall) {
    for (const double size : {0.002, 0.05, 0.3, 0.39, 0.41, 0.79, 1.7, 2.1})
        for (const bool linked : {true, false}) {
            Notes notes;
            expect_sound(ringed_zigzag(rectangle(0, 0, size, size), {.linked = linked}, notes));
            expect_sound(ringed_zigzag(rectangle(0, 0, 10, size), {.linked = linked}, notes));
        }
}

TEST(RingedZigzag, IsRepeatable) {
    Notes notes;
    for (const auto& region : random_regions(11))
        EXPECT_TRUE(same(ringed_zigzag(region, {}, notes), ringed_zigzag(region, {}, notes)));
}

} // namespace
} // namespace filum::fill
