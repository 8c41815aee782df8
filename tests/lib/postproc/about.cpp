// The head of a program: stages, notes and facts in full, in order, on lines that every reader takes.
#include "postproc/about.hpp"
#include "sample.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace filum;

TEST(About, NotesAreSummedAndFactsStand) {
    Note a, b;
    a.stage = b.stage = "fill";
    a.what = b.what = "area not reached";
    a.unit = b.unit = "mm2";
    a.amount = 1.5, b.amount = 0.25, b.count = 3;
    postproc::FirstPass first_pass;
    first_pass.layers = 7;
    first_pass.seconds = 3725;
    const auto lines = postproc::about(sample::profile(), first_pass,
                                       {{"slice", {{"layer-height", "0.2"}, {"set", ""}}}, {"fill", {}}}, {a, b},
                                       {{"sequence", "strokes", 12, ""}, {"sequence", "travel", 1.25, "mm"}});
    const auto has = [&](const std::string& line) {
        return std::find(lines.begin(), lines.end(), line) != lines.end();
    };
    EXPECT_TRUE(has(" - slice --layer-height=0.2 |"));
    EXPECT_TRUE(has(" - fill"));
    EXPECT_TRUE(has(" note: fill: area not reached, 4 x, 1.75 mm2"));
    EXPECT_TRUE(has(" sequence: strokes = 12"));
    EXPECT_TRUE(has(" sequence: travel = 1.25 mm"));
    EXPECT_TRUE(has("TIME:3725"));
    EXPECT_TRUE(has(" estimated printing time (normal mode) = 1h 2m 5s"));
    for (const auto& line : lines) EXPECT_LE(line.size(), 100u);
}
