#include "regions/bodies.hpp"
#include "regions/stack.hpp"

#include <gtest/gtest.h>

namespace filum::regions {
namespace {

using polygon::Layer;
using polygon::Region;

polygon::Loops rectangle(double x0, double y0, double x1, double y1) {
    polygon::Loops out;
    out.add(std::vector<geom::Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    return out;
}

Layer body(std::uint32_t index, std::uint32_t number, std::uint32_t tool, polygon::Loops contours) {
    return {index, 0.2 * (index + 1), 0.2, 0.2 * index + 0.1, std::move(contours), number, tool};
}

std::vector<Region> regions_of(const std::vector<Layer>& bodies, Gaps& gaps) {
    Notes notes;
    return body_regions(bodies, {}, &gaps, notes);
}

TEST(Bodies, TouchingOnesOfOneToolAreOneRegion) {
    Gaps gaps;
    const auto one = regions_of({body(0, 3, 1, rectangle(0, 0, 5, 5)), body(0, 7, 1, rectangle(5, 0, 9, 5))}, gaps);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_NEAR(one[0].area, 45, 1e-6);
    EXPECT_EQ(one[0].body, 3U);
    EXPECT_EQ(one[0].tool, 1U);

    const auto apart = regions_of({body(0, 3, 1, rectangle(0, 0, 5, 5)), body(0, 7, 1, rectangle(6, 0, 9, 5))}, gaps);
    ASSERT_EQ(apart.size(), 2U);
    EXPECT_EQ(apart[0].body + apart[1].body, 10U);

    const auto two = regions_of({body(0, 0, 1, rectangle(0, 0, 5, 5)), body(0, 1, 0, rectangle(5, 0, 9, 5))}, gaps);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[0].tool, 0U); // by tool
    EXPECT_EQ(two[0].body, 1U);
    EXPECT_EQ(two[1].id, 1U);
    EXPECT_EQ(gaps.layers, 0U);
}

TEST(Bodies, ACoreHasItsRingAsParent) {
    polygon::Loops ring = rectangle(0, 0, 9, 9);
    ring.add(std::vector<geom::Vec2>{{3, 3}, {3, 6}, {6, 6}, {6, 3}});
    Gaps gaps;
    const auto r = regions_of({body(0, 0, 0, ring), body(0, 1, 1, rectangle(3, 3, 6, 6))}, gaps);
    ASSERT_EQ(r.size(), 2U);
    EXPECT_EQ(r[0].parent, -1);
    EXPECT_EQ(r[1].parent, 0);
    EXPECT_EQ(gaps.layers, 0U);
}

TEST(Bodies, StrokesClimbOnlyWithinATool) {
    // Two bodies side by side, whose border moves from layer to layer.
    Gaps gaps;
    Stack stack({}, 1);
    Notes notes;
    for (std::uint32_t l = 0; l < 3; ++l) {
        const double border = 5 - l;
        EXPECT_TRUE(stack.add(body(l, 0, 0, rectangle(0, 0, border, 5)), notes).empty());
        EXPECT_TRUE(stack.add(body(l, 1, 1, rectangle(border, 0, 9, 5)), notes).empty());
    }
    const auto r = stack.end(notes);
    ASSERT_EQ(r.size(), 6U);
    for (const Region& one : r) {
        double under = 0;
        for (const polygon::Overlap& o : one.below) {
            under += o.area;
            EXPECT_EQ(o.link, r[o.below].tool == one.tool);
            EXPECT_EQ(r[o.below].layer + 1, one.layer);
        }
        if (one.layer > 0) {
            EXPECT_NEAR(under, one.area, 1e-3);
            EXPECT_EQ(one.below.size(), one.tool == 1 ? 2U : 1U);
        }
        EXPECT_EQ(one.unsupported, 0);
    }
    EXPECT_FALSE(note(stack.gaps()));
}

TEST(Bodies, GapsTooNarrowForABeadAreReported) {
    const auto volume = [](double gap, std::uint32_t tool) {
        Gaps gaps;
        regions_of({body(0, 0, 0, rectangle(0, 0, 5, 5)), body(0, 1, tool, rectangle(5 + gap, 0, 9, 5))}, gaps);
        return gaps.volume;
    };
    EXPECT_NEAR(volume(0.2, 1), 0.2 * 5 * 0.2, 0.01);
    EXPECT_NEAR(volume(0.39, 1), 0.39 * 5 * 0.2, 0.03);
    EXPECT_EQ(volume(0.41, 1), 0); // a bead fits
    EXPECT_EQ(volume(0.03, 1), 0); // a hairline
    EXPECT_EQ(volume(0.2, 0), 0);  // within one tool
    Gaps corner;                   // closing rounds the corner between bodies, which is no gap
    regions_of({body(0, 0, 0, rectangle(0, 0, 9, 2)), body(0, 1, 1, rectangle(4, 2, 6, 6))}, corner);
    EXPECT_EQ(corner.volume, 0);
}

TEST(Bodies, BeadsOfTheirOwnWidthDecideWhatIsThin) {
    Gaps gaps;
    Notes notes;
    Layer thin = body(0, 0, 0, rectangle(0, 0, 0.06, 5));
    EXPECT_EQ(body_regions(std::vector{thin}, {}, &gaps, notes).size(), 1U);
    thin.width = 1; // a hairline of 0.1 mm
    EXPECT_EQ(body_regions(std::vector{thin}, {}, &gaps, notes).size(), 0U);
    thin.contours = rectangle(0, 0, 3, 5);
    EXPECT_EQ(body_regions(std::vector{thin}, {}, &gaps, notes).at(0).width, 1);
}

} // namespace
} // namespace filum::regions
