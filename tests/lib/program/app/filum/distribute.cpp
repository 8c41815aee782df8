#include "app/filum/distribute.hpp"
#include "app/filum/process.hpp"
#include "base/error.hpp"

#include <gtest/gtest.h>

#include <csignal>

namespace filum::app::filum {
namespace {

const std::vector<Stage> kStages{{"slice", "", "", "", "", {{"height", true}, {"fast", false}, {"output", true}}},
                                 {"fill", "", "", "", "", {{"height", true}, {"width", true}, {"output", true}}}};

using Lists = std::vector<std::vector<std::string>>;

TEST(Route, OptionsGoToAllThatHaveThemOwnOnesLast) {
    const auto r =
        distribute({"--fill.height=2", "part.stl", "--height", "-1", "--fast", "--width=0.4", "-o", "x"}, kStages);
    EXPECT_EQ(r.arguments, (Lists{{"--height=-1", "--fast"}, {"--height=-1", "--width=0.4", "--height=2"}}));
    EXPECT_EQ(r.inputs, std::vector<std::string>{"part.stl"});
    EXPECT_EQ(r.output, "x");
}

TEST(Route, MachineIsTheHeadToKeepClearOfUnlessAnotherIsGiven) {
    const std::vector<Stage> stages{{"sequence", "", "", "", "", {{"head", true}}},
                                    {"link3d", "", "", "", "", {{"head", true}}},
                                    {"postproc", "", "", "", "", {{"machine", true}}}};
    const auto heads = [&](const std::vector<std::string>& words) { return distribute(words, stages).arguments; };
    EXPECT_EQ(heads({}), (Lists{{}, {}, {}}));
    EXPECT_EQ(heads({"--machine", "bio"}), (Lists{{"--head=bio"}, {"--head=bio"}, {"--machine=bio"}}));
    EXPECT_EQ(heads({"--postproc.machine=bio"}), (Lists{{"--head=bio"}, {"--head=bio"}, {"--machine=bio"}}));
    EXPECT_EQ(heads({"--machine=bio", "--head=none"}), (Lists{{"--head=none"}, {"--head=none"}, {"--machine=bio"}}));
    EXPECT_EQ(heads({"--sequence.head=none", "--machine=bio"}),
              (Lists{{"--head=none"}, {"--head=bio"}, {"--machine=bio"}}));
}

TEST(Route, AnOptionForAllGoesWhereItDoesSomething) {
    const std::vector<Stage> stages{
        {"fill", "", "", "", "", {{"method", true, "cyc", ""}, {"shift", true, "1", "method=paper"}}},
        {"link", "", "", "", "", {{"links", true, "free", ""}, {"shift", true, "1", "links=paper"}}}};
    const auto given = [&](const std::vector<std::string>& words) { return distribute(words, stages).arguments; };
    EXPECT_EQ(given({"--shift=2", "--method=paper"}), (Lists{{"--shift=2", "--method=paper"}, {}}));
    EXPECT_EQ(given({"--shift=2", "--links=paper"}), (Lists{{}, {"--shift=2", "--links=paper"}}));
    EXPECT_EQ(given({"--shift=2", "--links=paper", "--method=paper"}),
              (Lists{{"--shift=2", "--method=paper"}, {"--shift=2", "--links=paper"}}));
    EXPECT_EQ(given({"--shift=2"}), (Lists{{"--shift=2"}, {"--shift=2"}})); // both will say what it needs
    EXPECT_EQ(given({"--fill.shift=2"}), (Lists{{"--shift=2"}, {}}));
}

TEST(Route, BehindTwoDashesAllAreNames) {
    EXPECT_EQ(distribute({"--", "--fast"}, kStages).inputs, std::vector<std::string>{"--fast"});
    EXPECT_EQ(distribute({"--fast", "--", "-o"}, kStages).inputs, std::vector<std::string>{"-o"});
    EXPECT_EQ(distribute({"a", "--", "--b", "c"}, kStages).inputs, (std::vector<std::string>{"a", "--b", "c"}));
}

TEST(Route, SuggestsWhatWasMeant) {
    const auto why = [](const std::vector<std::string>& words) -> std::string {
        try {
            distribute(words, kStages);
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    };
    EXPECT_NE(why({"--heigth=1"}).find("did you mean '--height'?"), std::string::npos);
    EXPECT_NE(why({"--fil.width=1"}).find("did you mean '--fill'?"), std::string::npos);
    EXPECT_NE(why({"--fill.widht=1"}).find("did you mean '--fill.width'?"), std::string::npos);
    EXPECT_NE(why({"-height"}).find("did you mean '--height'?"), std::string::npos);
}

TEST(Route, RefusesWhatIsNobodys) {
    for (const auto& words : std::vector<std::vector<std::string>>{{"--nothing"},
                                                                   {"--slice.width=1"},
                                                                   {"--other.width=1"},
                                                                   {"--height"},
                                                                   {"-o"},
                                                                   {"a", ""},
                                                                   {"-x"},
                                                                   {""},
                                                                   {"--fill.output=x"}}) {
        try {
            distribute(words, kStages);
            ADD_FAILURE() << words[0];
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::usage);
        }
    }
}

TEST(Verdict, IsTheFirstThatFailedByItself) {
    const ProcessEnd fine{}, pipe{128 + SIGPIPE, true}, cut{4, false}, bad{3, false}, killed{128 + SIGKILL, true};
    std::size_t who = 9;
    EXPECT_EQ(verdict({fine, fine}, who), 0);
    EXPECT_EQ(verdict({pipe, bad, cut}, who), 3);
    EXPECT_EQ(who, 1U);
    EXPECT_EQ(verdict({fine, killed, cut}, who), 128 + SIGKILL);
    EXPECT_EQ(who, 1U);
    EXPECT_EQ(verdict({cut, cut}, who), 4); // the first reads no stage
    EXPECT_EQ(who, 0U);
    EXPECT_EQ(verdict({pipe, pipe, ProcessEnd{5, false}}, who), 5);
    EXPECT_EQ(who, 2U);
}

TEST(Process, PipesCarryDataAndCodesComeBack) {
    const auto ended = run_piped({{"/bin/sh", "-c", "echo data; exit 3"}, {"/bin/sh", "-c", "grep -q data"}});
    ASSERT_EQ(ended.size(), 2U);
    EXPECT_EQ(ended[0].code, 3);
    EXPECT_EQ(ended[1].code, 0);
    EXPECT_EQ(run_piped({{"/no/such/program"}})[0].code, 127);
    EXPECT_EQ(output_of({"/bin/sh", "-c", "echo x"}), "x\n");
    EXPECT_THROW(output_of({"/bin/sh", "-c", "exit 1"}), Error);
}

} // namespace
} // namespace filum::app::filum
