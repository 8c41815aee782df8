// The sections [tools] and [fibre], and how a stroke is divided.
#include "machine/fibre.hpp"
#include "base/error.hpp"
#include "machine/profile.hpp"

#include <gtest/gtest.h>

namespace filum::machine {
namespace {

constexpr const char* kLeast = "name = \"t\"\n[bed]\nx = [0, 400]\ny = [0, 400]\nz = [0, 400]\n[extrusion]\n"
                               "kind = \"filament\"\ndiameter = 1.75\n[tools]\nchange = \"T{tool_no}\"\n";

Profile with(const std::string& fibre) { return parse_profile(kLeast + ("[fibre]\n" + fibre), "t.toml"); }

std::string refusal(const std::string& fibre) {
    try {
        (void)with(fibre);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

Fibre head() {
    Fibre f;
    f.cut_to_nozzle = f.least_path = 45;
    f.anchor = 6;
    f.anchor_feed = 0.5;
    f.feed = 10;
    f.tail_feed = 4;
    f.ratio = 1.5;
    f.tension_dwell = 1;
    return f;
}

TEST(Fibre, WithoutASectionThereIsNone) {
    const Profile p = parse_profile(kLeast, "t.toml");
    EXPECT_FALSE(p.fibre.active());
    EXPECT_FALSE(p.fibre.lays(1));
}

TEST(Fibre, AStrokeIsAtLeastAsLongAsTheCutterIsFar) {
    const Profile p = with("cut = \"M64 P0\"\ncut_to_nozzle = 50\n");
    EXPECT_TRUE(p.fibre.active());
    EXPECT_TRUE(p.fibre.lays(1));
    EXPECT_FALSE(p.fibre.lays(0));
    EXPECT_EQ(p.fibre.least_path, 50);
    EXPECT_EQ(with("cut = \"C\"\ncut_to_nozzle = 50\nleast_path = 80\n").fibre.least_path, 80);
    EXPECT_NE(refusal("cut = \"C\"\ncut_to_nozzle = 50\nleast_path = 40\n").find("fibre.least_path"),
              std::string::npos);
}

TEST(Fibre, WhatCannotBeIsRefusedWithItsKey) {
    const std::string least = "cut = \"C\"\ncut_to_nozzle = 50\n";
    const std::pair<std::string, std::string> wrong[] = {
        {"cut_to_nozzle = 50\n", "fibre.cut"},
        {"cut = \"C\"\n", "fibre.cut_to_nozzle"},
        {"cut = \"C\"\ncut_to_nozzle = -1\n", "fibre.cut_to_nozzle"},
        {"cut = \"C\"\ncut_to_nozzle = nan\n", "fibre.cut_to_nozzle"},
        {"cut = \"C\"\ncut_to_nozzle = 1e-6\n", "fibre.cut_to_nozzle"},
        {"cut = \"{nosuch}\"\ncut_to_nozzle = 50\n", "fibre.cut"},
        {least + "most_path = 40\n", "fibre.most_path"},
        {least + "tension_dwell = 1\n", "fibre.tension"},
        {least + "tension_every = 0.001\n", "fibre.tension_every"},
        {least + "mode = \"drag\"\n", "fibre.mode"},
        {least + "feed = 0\n", "fibre.feed"},
        {least + "feed = 5000\n", "fibre.feed"},
        {least + "ratio = 0\n", "fibre.ratio"},
        {least + "tool = -1\n", "fibre.tool"},
        {least + "nosuch = 1\n", "fibre.nosuch"},
    };
    for (const auto& [text, key] : wrong)
        EXPECT_NE(refusal(text).find("key '" + key + "'"), std::string::npos) << text << refusal(text);
    const std::string alone = "name = \"t\"\n[bed]\nx = [0, 1]\ny = [0, 1]\nz = [0, 1]\n[extrusion]\nkind = "
                              "\"filament\"\ndiameter = 1\n[fibre]\n" +
                              least;
    EXPECT_THROW((void)parse_profile(alone, "t.toml"), Error); // tool 1 beside tool 0, and no way to change
    EXPECT_NO_THROW((void)parse_profile(alone + "tool = 0\n", "t.toml"));
}

TEST(Stretches, AnchorThenPullThenCutAndTail) {
    const auto s = stretches(head(), 100);
    ASSERT_EQ(s.size(), 3U);
    EXPECT_EQ(s[0].from, 0);
    EXPECT_EQ(s[0].to, 6);
    EXPECT_EQ(s[0].feed, 0.5);
    EXPECT_EQ(s[0].fed, 1.5);
    EXPECT_EQ(s[0].before, Event::none);
    EXPECT_EQ(s[1].to, 55);
    EXPECT_EQ(s[1].feed, 10);
    EXPECT_EQ(s[1].fed, 0);
    EXPECT_EQ(s[1].before, Event::tension);
    EXPECT_EQ(s[2].from, 55);
    EXPECT_EQ(s[2].to, 100);
    EXPECT_EQ(s[2].feed, 4);
    EXPECT_EQ(s[2].fed, 0);
    EXPECT_EQ(s[2].before, Event::cut);
}

TEST(Stretches, PushFeedsToTheCutAndPausesComeAtTheirDistance) {
    Fibre f = head();
    f.push = true;
    f.tension_every = 20;
    const auto s = stretches(f, 100); // 0 6 26 46 55 100
    ASSERT_EQ(s.size(), 5U);
    const double ends[] = {6, 26, 46, 55, 100};
    for (std::size_t i = 0; i < s.size(); ++i) {
        EXPECT_DOUBLE_EQ(s[i].to, ends[i]);
        EXPECT_EQ(s[i].fed, i < 4 ? 1.5 : 0);
        EXPECT_EQ(s[i].before, i == 0 ? Event::none : i < 4 ? Event::tension : Event::cut);
    }
}

TEST(Stretches, ACutMayComeWithinTheAnchorOrAtOnce) {
    auto s = stretches(head(), 48);
    ASSERT_EQ(s.size(), 2U);
    EXPECT_EQ(s[0].to, 3);
    EXPECT_EQ(s[1].before, Event::cut);
    s = stretches(head(), 45);
    ASSERT_EQ(s.size(), 1U);
    EXPECT_EQ(s[0].before, Event::cut);
    EXPECT_EQ(s[0].from, 0);
    Fibre f = head();
    f.anchor = 0; // nothing to wait for before anything is laid
    EXPECT_EQ(stretches(f, 100)[0].before, Event::none);
}

} // namespace
} // namespace filum::machine
