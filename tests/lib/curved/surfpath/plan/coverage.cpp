// Notes report the voids and the overlap of a plan, with area and place.
#include "surfpath/plan/coverage.hpp"

#include "surface/curve/locate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace filum::surfpath {

using namespace plan;
namespace {

Surface square(double size, double z = 0) {
    Notes notes;
    return surface::connect({{{0, 0, z}, {size, 0, z}, {size, size, z}, {0, size, z}}, {{0, 1, 2}, {0, 2, 3}}}, notes);
}

Plan rows(const Surface& s, double from, double to, double spacing) {
    const surface::curve::Locator locator(s);
    Plan out;
    for (double y = from; y < to; y += spacing)
        out.strokes.push_back({{{{{locator.nearest({0, y, 0}), locator.nearest({20, y, 0})}, false}, false}}});
    return out;
}

const Note* note(const Plan& plan, const std::string& what) {
    const auto it =
        std::find_if(plan.notes.begin(), plan.notes.end(), [&](const Note& n) { return code_name(n) == what; });
    return it == plan.notes.end() ? nullptr : &*it;
}

// The facts "bare", "uncovered", "laid-twice", and that there are notes of just those beyond their share.
std::array<double, 3> told(const Surface& s, Plan plan) {
    report_coverage(s, plan, 1);
    const std::array<const char*, 3> facts{"bare", "uncovered", "laid-twice"},
        notes{"no-line-near", "area-bare", "area-doubled"};
    const std::array<double, 3> shares{0.01, 0.04, 0.04};
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(plan.facts.at(k).name, facts[k]);
        out[k] = plan.facts[k].value;
        const Note* n = note(plan, notes[k]);
        EXPECT_EQ(n != nullptr, out[k] > shares[k] * surface::area(s)) << notes[k];
        if (n != nullptr) {
            EXPECT_EQ(n->amount, out[k]);
        }
    }
    return out;
}

TEST(Bare, RowsAtTheirSpacingLeaveNothing) {
    const Surface s = square(20);
    const auto [bare, uncovered, twice] = told(s, rows(s, 0.5, 20, 1));
    EXPECT_EQ(bare, 0);
    EXPECT_EQ(uncovered, 0);
    EXPECT_NEAR(twice, 0, 1e-6);
}

TEST(Bare, WhatIsMissingIsToldWithItsPlace) {
    const Surface s = square(20);
    Plan plan = rows(s, 0.5, 12, 1); // nothing from y = 11.5 on: bare from 12.5, uncovered from 12
    const auto [bare, uncovered, twice] = told(s, plan);
    EXPECT_NEAR(bare, 20 * 7.5, 3);
    EXPECT_NEAR(uncovered, 20 * 8, 3);
    EXPECT_NEAR(twice, 0, 3);
    report_coverage(s, plan, 1);
    for (const char* what : {"no-line-near", "area-bare"}) {
        ASSERT_NE(note(plan, what), nullptr);
        EXPECT_GT(note(plan, what)->y, 13);
        EXPECT_EQ(note(plan, what)->z, 0);
        EXPECT_EQ(unit(*note(plan, what)), "mm2");
    }
    EXPECT_NEAR(told(s, {})[0], 400, 1e-6);
}

TEST(Bare, WhatIsLaidTwiceIsToldWithItsPlace) {
    const Surface s = square(20, 3);
    Plan plan = rows(s, 0.5, 20, 1);
    Plan again = rows(s, 15.5, 18, 1); // three rows once more
    plan.strokes.insert(plan.strokes.end(), again.strokes.begin(), again.strokes.end());
    const auto [bare, uncovered, twice] = told(s, plan);
    EXPECT_EQ(bare, 0);
    EXPECT_EQ(uncovered, 0);
    EXPECT_NEAR(twice, 3 * 20, 1);
    report_coverage(s, plan, 1);
    ASSERT_NE(note(plan, "area-doubled"), nullptr);
    EXPECT_GT(note(plan, "area-doubled")->y, 14.9);
    EXPECT_LT(note(plan, "area-doubled")->y, 18.1);
    EXPECT_EQ(note(plan, "area-doubled")->z, 3);
}

// A line on the other skin of a thin wall covers nothing of this one.
TEST(Bare, WallsAreNotSeenThrough) {
    Notes notes;
    const Surface s = surface::connect(
        {{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 0, -0.3}, {20, 0, -0.3}, {20, 20, -0.3}, {0, 20, -0.3}},
         {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}}},
        notes);
    EXPECT_NEAR(told(s, rows(s, 0.5, 20, 1))[0], 400, 1e-6);
}

} // namespace
} // namespace filum::surfpath
