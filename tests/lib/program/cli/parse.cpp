#include "cli/parse.hpp"
#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/document.hpp"
#include "cli/other_names.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::cli {
namespace {

struct Options {
    double width = 0.4;
    std::int64_t count = 3;
    bool flag = false;
    enum class Order : std::uint8_t { layers, greedy } order = Order::layers;
    std::vector<double> move{0, 0, 0};
    std::string file;
};

Spec spec(Options& o) {
    return {.name = "stage",
            .synopsis = "does something",
            .description = "One paragraph.\n\n.Another, \"quoted\" - with 'all' that roff\\minds.",
            .in = reads(stream::Payload::layers),
            .out = writes(stream::Payload::regions),
            .memory = "one layer",
            .options = {Option{"width", &o.width, "MM", "a width"}.above(0).at_most(10),
                        Option{"count", &o.count, "N", "how many"}.at_least(1),
                        {"flag", &o.flag, "", "on or off"},
                        Option{"order", &o.order, "", "how"}.one_of({"layers", "greedy"}),
                        Option{"move", &o.move, "X,Y,Z", "where to"}.numbers(3),
                        Option{"file", &o.file, "FILE", "a file"}.not_a_setting()},
            .examples = {{"slice part.stl | stage", "an example"}}};
}

std::string parse_words(std::vector<std::string> words, Options& o, Io& io) {
    words.insert(words.begin(), "stage");
    std::vector<char*> argv;
    for (auto& w : words) argv.push_back(w.data());
    return parse(static_cast<int>(argv.size()), argv.data(), spec(o), io);
}

std::string refusal(const std::vector<std::string>& words) {
    Options o;
    Io io;
    try {
        parse_words(words, o, io);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        const std::string what = e.what();
        EXPECT_FALSE(std::isupper(static_cast<unsigned char>(what[0]))) << what;
        EXPECT_NE(what.back(), '.') << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return what;
    }
    return "";
}

TEST(Parse, BindsEveryKindOfOption) {
    Options o;
    Io io;
    EXPECT_EQ(parse_words({"--width", "0.5", "--count=7", "--flag", "--order", "greedy", "--move", "-1,2.5,-3e1",
                           "--file", "f", "in.layers", "-o", "out", "--threads", "2", "-q"},
                          o, io),
              "");
    EXPECT_EQ(o.width, 0.5);
    EXPECT_EQ(o.count, 7);
    EXPECT_TRUE(o.flag);
    EXPECT_EQ(o.order, Options::Order::greedy);
    EXPECT_EQ(o.move, (std::vector<double>{-1, 2.5, -30}));
    EXPECT_EQ(o.file, "f");
    EXPECT_EQ(io.input, "in.layers");
    EXPECT_EQ(io.output, "out");
    EXPECT_EQ(io.threads, 2);
    EXPECT_TRUE(io.quiet);
}

TEST(Parse, SettingsAreResolvedAndTellWhatWasChanged) {
    Options o;
    Io io;
    parse_words({"--width=0.50", "--count", "3", "--file", "secret"}, o, io);
    ASSERT_EQ(io.settings.size(), 5U); // the file is none
    EXPECT_EQ(io.settings[0].name, "width");
    EXPECT_EQ(io.settings[0].value, "0.5");
    EXPECT_TRUE(io.settings[0].changed);
    EXPECT_EQ(io.settings[1].value, "3");
    EXPECT_FALSE(io.settings[1].changed); // given, but as the default has it
    EXPECT_EQ(io.settings[4].value, "0,0,0");
}

TEST(Parse, TheLastOfTwoWins) {
    Options o;
    Io io;
    parse_words({"--width=0.5", "--width=0.6"}, o, io);
    EXPECT_EQ(o.width, 0.6);
}

TEST(Parse, RefusesWhatDoesNotFitAndSaysWhy) {
    EXPECT_NE(refusal({"--width", "0"}).find("above 0 and at most 10"), std::string::npos);
    EXPECT_NE(refusal({"--width", "11"}), "");
    EXPECT_NE(refusal({"--width", "nan"}), "");
    EXPECT_NE(refusal({"--width", "1e400"}), "");
    EXPECT_NE(refusal({"--width", ""}), "");
    EXPECT_NE(refusal({"--width"}), "");
    EXPECT_NE(refusal({"--count", "1.5"}).find("whole number"), std::string::npos);
    EXPECT_NE(refusal({"--count", "0"}), "");
    EXPECT_NE(refusal({"--order", "other"}).find("layers, greedy"), std::string::npos);
    EXPECT_NE(refusal({"--move", "1,2"}).find("3 numbers"), std::string::npos);
    EXPECT_NE(refusal({"--move", "1,2,"}), "");
    EXPECT_NE(refusal({"--flag=maybe"}), "");
    EXPECT_NE(refusal({"--nothing"}).find("unknown option '--nothing'"), std::string::npos);
    EXPECT_NE(refusal({"one", "two"}).find("'two'"), std::string::npos);
    EXPECT_NE(refusal({"--threads", "-1"}), "");
    EXPECT_NE(refusal({""}), "");
    EXPECT_NE(refusal({"--output", ""}), "");
}

// A stage whose options depend on each other.
struct Dependent {
    std::string pattern = "spiral";
    double spacing = 0, angle = 0, stagger = 0;
    bool fast = false;
    std::string surface;
};

Spec dependent(Dependent& o) {
    return {.name = "stage",
            .synopsis = "",
            .description = "",
            .in = nothing(),
            .out = nothing(),
            .memory = "",
            .options = {Option{"pattern", &o.pattern, "", "how"}.one_of({"spiral", "rows", "lattice"}),
                        Option{"spacing", &o.spacing, "MM", "apart"}.zero_or_at_least(0.1).at_most(9).when(
                            "pattern=lattice"),
                        Option{"angle", &o.angle, "DEG", "turned"}.within(-360, 360).when("!pattern=spiral"),
                        Option{"stagger", &o.stagger, "MM", "shift"}.within(0, 1).when("spacing/fast !surface"),
                        {"fast", &o.fast, "", "quick"},
                        Option{"surface", &o.surface, "FILE", "on it"}.not_a_setting()},
            .examples = {}};
}

std::string dependent_refusal(std::vector<std::string> words) {
    words.insert(words.begin(), "stage");
    std::vector<char*> argv;
    for (auto& w : words) argv.push_back(w.data());
    Dependent o;
    Io io;
    try {
        parse(static_cast<int>(argv.size()), argv.data(), dependent(o), io);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        return e.what();
    }
    return "";
}

TEST(Needs, AnOptionWithoutEffectIsRefusedWithWhatItNeeds) {
    EXPECT_EQ(dependent_refusal({"--spacing=1"}),
              "cannot use --spacing: it does nothing without --pattern lattice; add that, or leave out --spacing");
    EXPECT_EQ(dependent_refusal({"--spacing=1", "--pattern=lattice"}), "");
    EXPECT_EQ(dependent_refusal({"--angle=5"}),
              "cannot use --angle: it does nothing with --pattern spiral; leave one out");
    EXPECT_EQ(dependent_refusal({"--angle=5", "--pattern=rows"}), "");
    EXPECT_NE(dependent_refusal({"--stagger=1"}).find("without --spacing or --fast"), std::string::npos);
    EXPECT_EQ(dependent_refusal({"--stagger=1", "--fast"}), "");
    EXPECT_EQ(dependent_refusal({"--stagger=1", "--spacing=2", "--pattern=lattice"}), "");
    EXPECT_NE(dependent_refusal({"--stagger=1", "--fast", "--surface=x"}).find("with --surface"), std::string::npos);
}

TEST(Needs, ADefaultAsksForNothing) {
    EXPECT_EQ(dependent_refusal({"--spacing=0", "--angle=0", "--stagger=0"}), "");
    EXPECT_NE(dependent_refusal({"--spacing=0.05", "--pattern=lattice"}).find("0, or at least 0.1 and at most 9"),
              std::string::npos);
}

TEST(Needs, StandInHelpAndContract) {
    Dependent o;
    EXPECT_NE(help(dependent(o)).find("(with --spacing or --fast, not with --surface)"), std::string::npos);
    EXPECT_NE(contract(dependent(o)).find("needs stagger spacing/fast !surface\n"), std::string::npos);
    EXPECT_NE(contract(dependent(o)).find("range spacing 0.1 9 zero\n"), std::string::npos);
}

TEST(Parse, SuggestsWhatWasMeant) {
    EXPECT_NE(refusal({"--witdh=1"}).find("did you mean '--width'?"), std::string::npos);
    EXPECT_NE(refusal({"-width", "1"}).find("'-width'"), std::string::npos);
    EXPECT_NE(refusal({"--order=gredy"}).find("did you mean 'greedy'?"), std::string::npos);
    EXPECT_NE(refusal({"--zzzzzzz"}).find("see 'stage --help'"), std::string::npos);
}

TEST(Parse, RandomWordsAreRefusedOrTakenNeverWorse) {
    std::mt19937 random(3);
    const std::vector<std::string> words{"--width",      "--width=1",    "=",       "--",  "-",   "-1",
                                         "--move=1,2,3", "\xff\xfe",     "--count", "-o",  "x",   "-q",
                                         "--flag",       "--flag=false", "---",     "-vv", "--=", "@"};
    for (int i = 0; i < 3000; ++i) {
        std::vector<std::string> line(random() % 5);
        for (auto& w : line) w = words[random() % words.size()];
        Options o;
        Io io;
        try {
            parse_words(line, o, io);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::usage);
        }
    }
}

TEST(Document, EveryOptionIsInEveryDocument) {
    Options o;
    const Spec s = spec(o);
    for (const std::string& text : {help(s), markdown(s), completion_line(s)})
        for (const char* name :
             {"--width", "--count", "--flag", "--order", "--move", "--file", "--output", "--threads"})
            EXPECT_NE(text.find(name), std::string::npos) << name;
    EXPECT_NE(completion_line(s).find("--order={layers,greedy}"), std::string::npos);
    EXPECT_NE(contract(s).find("\nin stream Layers\nout stream Regions\n"), std::string::npos);
    EXPECT_NE(contract(s).find("\nflag flag\n"), std::string::npos);
}

TEST(Document, HelpLinesAreAtMost100Wide) {
    Options o;
    const std::string text = help(spec(o));
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        EXPECT_LE(end - at, 100U) << text.substr(at, end - at);
        at = end + 1;
    }
}

TEST(Document, NoLineOfTheManualPageIsARequestByAccident) {
    Options o;
    const std::string page = man_page(spec(o));
    EXPECT_NE(page.find("\n\\&.Another, \\(dqquoted\\(dq"), std::string::npos) << page;
    EXPECT_NE(page.find("roff\\eminds"), std::string::npos);
}

TEST(Header, HistoriesAreJoinedWithTheirParents) {
    Io io;
    io.program = "join";
    io.settings = {{"a", "1", true}};
    stream::Header first, second;
    first.history = {{"slice", "1", {}, {}}, {"regions", "1", {}, {0}}};
    second.history = {{"slice", "1", {}, {}}};
    const auto h = header(io, stream::Payload::paths, {&first, &second});
    ASSERT_EQ(h.history.size(), 4U);
    EXPECT_EQ(h.history[1].parents, std::vector<std::uint32_t>{0});
    EXPECT_EQ(h.history[3].program, "join");
    EXPECT_EQ(h.history[3].parents, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Parse, AnOldNameIsAnsweredWithTheNewOne) {
    const std::vector<std::string> names{"min-radius", "spacing"};
    EXPECT_EQ(in_our_words("least-radius", names), "; here it is '--min-radius'");
    EXPECT_EQ(in_our_words("least-area", names), "");
    Options o;
    Io io;
    Spec s = spec(o);
    s.options[0].name = "min-radius";
    std::vector<std::string> words{"stage", "--least-radius=3"};
    std::vector<char*> argv{words[0].data(), words[1].data()};
    try {
        parse(2, argv.data(), s, io);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        EXPECT_STREQ(e.what(), "unknown option '--least-radius=3'; here it is '--min-radius'");
    }
}

} // namespace
} // namespace filum::cli
