// The head of a program: stages, notes and facts in full, in order, on lines that every reader takes.
#include "postproc/about.hpp"
#include "sample.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace filum;

TEST(About, NotesAreSummedAndFactsStand) {
    Note a, b;
    a.stage = b.stage = "fill";
    a.code = b.code = NoteCode::area_unreached;
    a.amount = 1.5;
    b.amount = 0.25;
    b.count = 3;
    postproc::FirstPass first_pass;
    first_pass.layers = 7;
    first_pass.strokes = 12;
    first_pass.seconds = 3725;
    const Facts facts{{"sequence", "planned-strokes", 12, ""}, {"sequence", "lower-bound", 11, "strokes"}};
    const auto lines =
        postproc::history({{"slice", {{"layer-height", "0.2"}, {"set", ""}}}, {"fill", {}}}, {a, b}, facts);
    const auto told = postproc::summary(sample::profile(), first_pass, {}, {a, b}, facts);
    const auto head = postproc::about(sample::profile(), first_pass, told, {a, b});
    const auto has = [&](const std::string& line) {
        return std::find(lines.begin(), lines.end(), line) != lines.end();
    };
    EXPECT_TRUE(has(" - slice --layer-height=0.2 |"));
    EXPECT_TRUE(has(" - fill"));
    EXPECT_TRUE(std::ranges::any_of(lines, [](const std::string& line) {
        return line.starts_with(" note: look: fill: 1.75 mm2 are reached by no bead (4 places); choose a smaller");
    }));
    EXPECT_TRUE(has(" sequence: planned-strokes = 12"));
    EXPECT_TRUE(has(" sequence: lower-bound = 11 strokes"));
    const auto told_first = [&](const std::string& line) {
        return std::find(head.begin(), head.end(), line) != head.end();
    };
    EXPECT_TRUE(told_first("TIME:3725"));
    EXPECT_TRUE(told_first(" estimated printing time (normal mode) = 1h 2m 5s"));
    ASSERT_EQ(told.size(), 3u);
    EXPECT_EQ(head[1], " " + told[0]);
    for (const auto& line : lines) EXPECT_LE(line.size(), 100u);
    for (const auto& line : head) EXPECT_LE(line.size(), 100u);
}

// The strokes are those of the program, not those that sequence planned; the bound is left out where it is not one of
// the job.
TEST(About, StrokesAreThoseOfTheProgram) {
    postproc::FirstPass first_pass;
    const auto says = [&](std::uint64_t strokes, double planned, double bound) {
        first_pass.strokes = strokes;
        return postproc::summary(sample::profile(), first_pass, {}, {},
                                 {{"sequence", "planned-strokes", planned, ""}, {"sequence", "lower-bound", bound, ""}})
            .front();
    };
    EXPECT_EQ(says(19, 19, 19), "19 strokes (proven the fewest); 18 stops");
    EXPECT_EQ(says(1, 1, 1), "1 stroke (proven the fewest); 0 stops");
    EXPECT_EQ(says(86, 85, 85), "86 strokes (at least 85 are needed); 85 stops");
    EXPECT_EQ(says(8, 1, 1), "8 strokes (at least 1 is needed); 7 stops");
    first_pass.strokes = 12; // of a core and 11 patches
    const Fact bound{"sequence", "lower-bound", 1, ""};
    const auto first_line = [&](const Facts& facts) {
        return postproc::summary(sample::profile(), first_pass, {}, {}, facts).front();
    };
    EXPECT_EQ(first_line({bound, {"assemble", "toolpaths", 12, ""}}), "12 strokes; 11 stops");
    EXPECT_EQ(first_line({bound, bound}), "12 strokes; 11 stops");
    EXPECT_EQ(first_line({bound, {"assemble", "toolpaths", 1, ""}}), "12 strokes (at least 1 is needed); 11 stops");
    first_pass.strokes = 3;
    EXPECT_EQ(postproc::summary(sample::profile(), first_pass, {}, {}, {}).front(), "3 strokes; 2 stops");
    EXPECT_EQ(postproc::summary(sample::profile(), first_pass, {}, {}, {}).back(),
              "nothing hangs, nothing was left out");
}
