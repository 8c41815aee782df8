#include "render/collisions.hpp"
#include "decoded.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using namespace filum::render;

const std::string kHead = "point\tlayer\tstroke\tmove\tmeets\twith\tclearance\tx\ty\tz\ti\tj\tk\n";

std::string line(std::uint64_t point, double clearance, const std::string& with = "nozzle") {
    return std::to_string(point) + "\t0\t0\tbead\tpart\t" + with + "\t" + std::to_string(clearance) +
           "\t5\t0\t0\t0\t0\t1\n";
}

// A bead of ten points, the second half in a tower behind.
Scene beads() {
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {0.5}, {0.3}, {}};
    for (int i = 0; i < 5; ++i) s.points.push_back({i * 2.0, 0, 0});
    for (int i = 5; i < 10; ++i) s.points.push_back({8, 3, i * 1.0});
    Scene out;
    out.spans.push_back(s);
    return out;
}

// The picture of width x height.
Decoded picture(const Scene& scene, const Meetings& m, const machine::Head& head, ColourBy by, const View& view,
                int threads, int width = 400, int height = 200) {
    Canvas page(width, height, Format::png);
    draw_collisions(page, scene, m, head, by, view, threads);
    return decode(page.bytes());
}

// Pixels whose red is far above the rest.
int red(const Decoded& image) {
    int out = 0;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
        out += image.rgb[i] > 100 && image.rgb[i] > 2.5 * image.rgb[i + 1] && image.rgb[i] > 2.5 * image.rgb[i + 2];
    return out;
}

std::string refusal(const std::string& text) {
    try {
        read_meetings(text, "'list'");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

TEST(Collisions, TheListIsRead) {
    const Meetings m = read_meetings(kHead + line(3, -0.5) + line(4, 0), "'list'");
    EXPECT_TRUE(m.points);
    ASSERT_EQ(m.all.size(), 2U);
    EXPECT_EQ(m.all[0].source, 3U);
    EXPECT_EQ(m.all[0].clearance, -0.5);
    EXPECT_EQ(m.all[0].tip, (geom::Vec3{5, 0, 0}));
    EXPECT_FALSE(read_meetings("line" + kHead.substr(5) + line(3, 0), "'list'").points);
}

TEST(Collisions, WhatIsNoList) {
    EXPECT_NE(refusal("").find("names no place"), std::string::npos);
    EXPECT_NE(refusal(kHead).find("meets nothing"), std::string::npos);
    EXPECT_NE(refusal("x\ty\n").find("no list"), std::string::npos);
    EXPECT_NE(refusal(kHead + "3\t0\n").find("line 2"), std::string::npos);
    EXPECT_NE(refusal(kHead + line(1, 0) + line(2, NAN)).find("line 3"), std::string::npos);
    EXPECT_NE(refusal(kHead + "1\t0\t0\tbead\tpart\tnozzle\t0\t0\t0\t0\t0\t0\t9\n").find("line 2"), std::string::npos);
}

TEST(Collisions, ThePlaceIsSeen) {
    const View view{{0, 0, 0}, 4, false, true, {}};
    for (const char* piece : {"nozzle", "carriage", "gantry"}) {
        machine::Head head;
        head.gantry_height = 40;
        const auto m = read_meetings(kHead + line(3, -0.5, piece), "'list'");
        const Decoded one = picture(beads(), m, head, ColourBy::progress, view, 1);
        EXPECT_GT(red(one), 8) << piece;
        EXPECT_EQ(one.rgb, picture(beads(), m, head, ColourBy::progress, view, 2).rgb);
    }
    // sizes of nothing, and far too large
    const auto m = read_meetings(kHead + line(3, -0.5, "carriage"), "'list'");
    EXPECT_GT(red(picture(beads(), m, {0.2, 0, 0, 0, 0, 0}, ColourBy::progress, view, 1)), 4);
    EXPECT_EQ(picture(beads(), m, {50, 1, 900, 1e4, 1e4}, ColourBy::progress, view, 1).width, 400U);
    EXPECT_GT(red(picture({}, m, {}, ColourBy::progress, view, 1)), 4);
}

// What is laid after the place does not stand in the picture.
TEST(Collisions, OnlyWhatIsThereThen) {
    const View view{{1, -1, 0.5}, 4, false, true, {}};
    Scene early = beads();
    early.spans[0].points.resize(4);
    const auto at = [&](int point) { return read_meetings(kHead + line(point, 0), "'list'"); };
    const auto draw = [&](const Scene& s, const Meetings& m) {
        return picture(s, m, {}, ColourBy::layer, view, 1, 240, 120).rgb;
    };
    EXPECT_EQ(draw(beads(), at(3)), draw(early, at(3)));
    EXPECT_NE(draw(beads(), at(3)), draw(beads(), at(9)));
}

} // namespace
