// What a plan leaves without a bead is told, with area and place.
#include "surfpath/bare.hpp"

#include "surface/curve/locate.hpp"

#include <gtest/gtest.h>

namespace filum::surfpath {
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

// The fact, and that there is a note of the same.
double told(const Surface& s, Plan plan) {
    tell_bare(s, plan, 1);
    EXPECT_EQ(plan.facts.at(0).name, "bare");
    EXPECT_EQ(plan.notes.size(), plan.facts[0].value > 0.01 * surface::area(s) ? 1U : 0U);
    for (const Note& note : plan.notes) EXPECT_EQ(note.amount, plan.facts[0].value);
    return plan.facts[0].value;
}

TEST(bare, rows_at_their_spacing_leave_nothing) {
    const Surface s = square(20);
    EXPECT_EQ(told(s, rows(s, 0.5, 20, 1)), 0);
}

TEST(bare, what_is_missing_is_told_with_its_place) {
    const Surface s = square(20);
    Plan plan = rows(s, 0.5, 12, 1); // nothing from y = 11.5 on: bare from 12.5
    EXPECT_NEAR(told(s, plan), 20 * 7.5, 3);
    tell_bare(s, plan, 1);
    EXPECT_GT(plan.notes.at(0).y, 13);
    EXPECT_EQ(plan.notes[0].unit, "mm2");
    EXPECT_NEAR(told(s, {}), 400, 1e-6);
}

// A line on the other skin of a thin wall covers nothing of this one.
TEST(bare, walls_are_not_seen_through) {
    Notes notes;
    const Surface s = surface::connect(
        {{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}, {0, 0, -0.3}, {20, 0, -0.3}, {20, 20, -0.3}, {0, 20, -0.3}},
         {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}}},
        notes);
    EXPECT_NEAR(told(s, rows(s, 0.5, 20, 1)), 400, 1e-6);
}

} // namespace
} // namespace filum::surfpath
