#include "decoded.hpp"
#include "render/canvas.hpp"
#include "render/draw.hpp"
#include "render/flat.hpp"
#include "render/layer.hpp"
#include "render/perspective.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace filum::render {

namespace {

toolpath::Span line(geom::Vec3 a, geom::Vec3 b, std::uint32_t layer = 0) {
    return {toolpath::Role::bead, 0, layer, 0, {a, b}, {0.4}, {0.2}};
}

polygon::Region square(double x0, double y0, double x1, double y1) {
    polygon::Region r;
    r.z = r.height = 0.2;
    const std::vector<geom::Vec2> p{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    r.loops.add(p);
    r.area = (x1 - x0) * (y1 - y0);
    return r;
}

// Ten lines of a square of 4 mm; the first `missing` left out.
Scene filled(int missing = 0, geom::Vec3 at = {}) {
    Scene s;
    for (int k = missing; k < 10; ++k)
        s.spans.push_back(line(at + geom::Vec3{0, 0.2 + 0.4 * k, 0.2}, at + geom::Vec3{4, 0.2 + 0.4 * k, 0.2}));
    return s;
}

// The text between two words of another one.
std::string between(const std::string& text, const std::string& before, const std::string& after) {
    const auto from = text.find(before);
    if (from == std::string::npos) return "";
    return text.substr(from + before.size(), text.find(after, from + before.size()) - from - before.size());
}

// The file without the numbers of names, which cairo counts from the start of the process.
std::string unnumbered(const std::string& svg) {
    return std::regex_replace(svg, std::regex("(surface|source-|image|glyph|clip|mask)[0-9]+"), "$1");
}

TEST(Canvas, AnImageComesBackAsItWas) {
    Image image(37, 21);
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 37; ++x)
            image.set(x, y, from_srgb8({static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(12 * y), 99}));
    Canvas page(37, 21, Format::png);
    page.image(image);
    const Decoded d = decode(page.bytes());
    ASSERT_EQ(d.width, 37u);
    ASSERT_EQ(d.height, 21u);
    EXPECT_EQ(d.rgb, image.rgb);
}

TEST(Flat, ShowsASquareOfItsSize) {
    Scene s = filled();
    add(s, square(0, 0, 4, 4), {});
    Options o;
    o.layer = 0;
    o.size = {300, 300};
    o.no_centres = true;
    const Decoded d = decode(draw(s, o, "progress", 1));
    // The longer side, 4.4 mm with the round ends, takes 0.94 of the width (or the shorter 0.90 of the height).
    const double side = std::min(0.94 * 300 / 4.4, 0.90 * 300 / 4.0) * 4;
    EXPECT_NEAR(d.share(colourful), side * side / 90000, 0.06);
    EXPECT_LT(d.share(red), 0.01); // the dots where lines end
}

TEST(Flat, ShowsVoidsRed) {
    Scene s = filled(5);
    add(s, square(0, 0, 4, 4), {});
    Options o;
    o.layer = 0;
    o.size = {300, 300};
    o.no_centres = true;
    const Decoded d = decode(draw(s, o, "progress", 1));
    const double side = std::min(0.94 * 300 / 4.4, 0.90 * 300 / 4.0) * 4;
    EXPECT_NEAR(d.share(red), 0.5 * side * side / 90000, 0.03);
}

TEST(Flat, MarksOverlapDark) {
    Scene once = filled(), twice = filled();
    for (const auto& s : filled().spans) twice.spans.push_back(s);
    const auto brightness = [](const Scene& s) {
        Options o;
        o.layer = 0;
        o.size = {200, 200};
        o.color = "layer";
        o.no_centres = true;
        const Decoded d = decode(draw(s, o, "layer", 1));
        const Srgb8 c = d.at(100, 104); // off the borders between beads
        return c.r + c.g + c.b;
    };
    EXPECT_LT(brightness(twice), 0.9 * brightness(once));
}

TEST(Flat, KnowsWhereStrokesStartAndEnd) {
    Scene s;
    s.spans.push_back(line({0, 0, 0.2}, {5, 0, 0.2}));
    s.spans.push_back(line({5, 0, 0.2}, {5, 5, 0.2}));
    s.spans.push_back({toolpath::Role::travel, 0, 0, 0, {{5, 5, 0.2}, {0, 5, 0.2}}, {}, {}});
    s.spans.push_back(line({0, 5, 0.2}, {0, 9, 0.2}));
    const FlatLayer l = flatten(s);
    ASSERT_EQ(l.marks.size(), 4u);
    EXPECT_EQ(l.marks[0].at, (geom::Vec2{0, 0}));
    EXPECT_EQ(l.marks[1].at, (geom::Vec2{5, 5}));
    EXPECT_EQ(l.marks[2].at, (geom::Vec2{0, 5}));
    EXPECT_EQ(l.marks[3].at, (geom::Vec2{0, 9}));
    EXPECT_EQ(l.travels.size(), 1u);
    EXPECT_NEAR(l.width, 0.4, 1e-12);
}

TEST(Canvas, LettersAreCapitalsOfTheSizeAsked) {
    Canvas page(400, 100, Format::png);
    page.text({10, 80}, 50, "HH", {0, 0, 0});
    const double wide = page.text_width(50, "HH");
    EXPECT_NEAR(page.text_width(50, "HHHH"), 2 * wide, 1e-6);
    EXPECT_LT(page.text_width(50, "ii"), wide / 2);
    EXPECT_NEAR(page.text_width(50, "\xc2\xb5"), page.text_width(50, "u"), 3); // a letter of two bytes is one letter
    const Decoded d = decode(page.bytes());
    unsigned top = 100, bottom = 0, right = 0;
    for (unsigned y = 0; y < 100; ++y)
        for (unsigned x = 0; x < 400; ++x)
            if (d.at(x, y).g < 128) top = std::min(top, y), bottom = std::max(bottom, y), right = std::max(right, x);
    EXPECT_NEAR(top, 30, 1);
    EXPECT_NEAR(bottom, 79, 1);
    EXPECT_NEAR(right, 10 + wide, 10); // a letter's own margin, less than a fifth of its size
}

TEST(Canvas, APartDrawsInItsPlaceAndNotBeyond) {
    Canvas page(60, 40, Format::png);
    Canvas inner = page.part(10, 5, 40, 30).part(10, 10, 10, 10);
    inner.line({-50, 5}, {50, 5}, {.width = 4, .colour = {}});
    const Decoded d = decode(page.bytes());
    EXPECT_NEAR(d.share([](Srgb8 c) { return c.g < 128; }) * 60 * 40, 40, 1);
    EXPECT_LT(d.at(25, 20).g, 10);
    EXPECT_GT(d.at(18, 20).g, 245);
    EXPECT_GT(d.at(31, 20).g, 245);
}

// The same beads in every format, in mm of the page.
TEST(Vector, HasTrueWidthsInMillimetres) {
    Options o;
    o.layer = 0;
    o.size = {440, 440};
    o.format = "svg";
    const std::string text = draw(filled(), o, "layer", 1);
    EXPECT_NE(text.find("<svg "), std::string::npos);
    // 4.4 mm with the round ends take 0.94 of the page's width (or 4 mm 0.90 of its height).
    const double scale = std::min(0.94 * 440 / 4.4, 0.90 * 440 / 4.0), page = 440 / scale;
    EXPECT_NEAR(std::stod(between(text, "width=\"", "pt\"")) / 72 * 25.4, page, 1e-4);
    std::size_t beads = 0;
    const std::regex width("stroke-width(:|=\")([0-9.]+)"); // a style, or from cairo 1.18 on an attribute
    for (std::sregex_iterator at(text.begin(), text.end(), width), end; at != end; ++at)
        beads += std::abs(std::stod((*at)[2]) - 0.4 * scale) < 1e-3 ? 1 : 0;
    EXPECT_EQ(beads, 10u);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(unnumbered(text), unnumbered(draw(filled(), o, "layer", 8)));
    o.format = "pdf";
    const std::string pdf = draw(filled(), o, "layer", 1);
    EXPECT_EQ(pdf.rfind("%PDF-", 0), 0u);
    // cairo 1.18 packs the page's size, so only the SVG's size is checked there.
    if (const std::string box = between(pdf, "MediaBox [ 0 0 ", " "); !box.empty()) {
        EXPECT_NEAR(std::stod(box) / 72 * 25.4, page, 1e-3);
    }
    EXPECT_EQ(pdf.find("CreationDate"), std::string::npos);
    EXPECT_EQ(pdf, draw(filled(), o, "layer", 1));
}

TEST(Vector, PicturesOfEveryKindBecomePages) {
    for (const char* format : {"svg", "pdf"}) {
        Options o;
        o.size = {120, 90};
        o.format = format;
        const std::string one = draw(filled(), o, "progress", 1);
        EXPECT_GT(one.size(), 1000u);
        EXPECT_EQ(unnumbered(one), unnumbered(draw(filled(), o, "progress", 2)));
        o.views = "iso,top";
        EXPECT_NE(draw(filled(), o, "progress", 1), one);
    }
}

TEST(Flat, AroundShowsAPlaceAsLargeAsAsked) {
    Options o;
    o.layer = 0;
    o.size = {200, 200};
    o.no_centres = true;
    o.around = {2, 0, 0, 1}; // the lower edge of the square, 2 mm across the page; the legend is below it
    const Decoded d = decode(draw(filled(), o, "layer", 1));
    EXPECT_NEAR(d.share(colourful), 0.5, 0.06);
}

TEST(Perspective, ShowsASlabFromAbove) {
    Options o;
    o.view = "top";
    o.size = {240, 180};
    o.no_table = true;
    const Decoded d = decode(draw(filled(), o, "layer", 1));
    const double side = 0.9 * 180; // 4 mm across the height, 4.4 along the width
    EXPECT_NEAR(d.share(colourful), side * side * 1.1 / (240 * 180), 0.12);
    EXPECT_FALSE(colourful(d.at(3, 3)));
}

// A wall of beads that are thinner than a pixel, seen from its side.
Scene fine_wall(int layers) {
    Scene s;
    for (int k = 0; k < layers; ++k)
        s.spans.push_back(
            line({0, 0.2 * (k % 2), 0.2 * k}, {40, 0.2 * (k % 2), 0.2 * k}, static_cast<std::uint32_t>(k)));
    return s;
}

// The mean difference of two pictures of one size, of 255.
double difference(const Decoded& a, const Decoded& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

TEST(Perspective, BeadsThinnerThanPixelsAreCalm) {
    for (const int layers : {100, 200, 400}) {
        const Scene s = fine_wall(layers);
        Options o;
        o.view = "0.3,-1,0.2";
        o.size = {120, 120};
        o.samples = 64;
        const Decoded right = decode(draw(s, o, "layer", 1));
        o.samples = 4;
        EXPECT_LT(difference(decode(draw(s, o, "layer", 1)), right), 10) << layers << " layers";
    }
}

TEST(Perspective, IsTheSameForAnyThreads) {
    Options o;
    o.size = {200, 150};
    const std::string one = draw(filled(), o, "progress", 1);
    EXPECT_EQ(one, draw(filled(), o, "progress", 2));
    EXPECT_EQ(one, draw(filled(), o, "progress", 8));
    o.layer = 0;
    EXPECT_EQ(draw(filled(), o, "progress", 1), draw(filled(), o, "progress", 8));
}

TEST(Perspective, IsTheSameFarFromTheOrigin) {
    Options o;
    o.size = {120, 90};
    // 2^20: nothing is lost by moving there but the last few bits.
    const Decoded here = decode(draw(filled(), o, "layer", 1));
    const Decoded there = decode(draw(filled(0, {1048576, -1048576, 0}), o, "layer", 1));
    std::size_t off = 0;
    for (std::size_t i = 0; i < here.rgb.size(); ++i) off += std::abs(here.rgb[i] - there.rgb[i]) > 24 ? 1 : 0;
    EXPECT_LT(static_cast<double>(off) / static_cast<double>(here.rgb.size()), 0.02);
}

TEST(Pictures, OfNothingAndNextToNothing) {
    Scene dot;
    dot.spans.push_back(line({1e8, 1e8, 0.2}, {1e8, 1e8, 0.2}));
    for (const bool flat : {false, true}) {
        for (const char* color : {"progress", "stroke", "layer", "width", "class"}) {
            Options o;
            o.size = {64, 48};
            o.color = color;
            o.layer = flat ? 0 : -1;
            EXPECT_EQ(decode(draw({}, o, color, 1)).width, 64u);
            EXPECT_EQ(decode(draw(dot, o, color, 1)).height, 48u);
            if (flat) o.format = "svg";
            EXPECT_EQ(draw(dot, o, color, 1).find("nan"), std::string::npos);
        }
    }
}

TEST(Pictures, OutlinesAreDrawnAsSolids) {
    Scene s;
    for (std::uint32_t k = 0; k < 10; ++k) {
        auto r = square(0, 0, 3, 3);
        r.layer = k;
        r.z = 0.2 * (k + 1);
        add(s, r, {});
    }
    Options o;
    o.size = {120, 90};
    o.no_table = true;
    EXPECT_GT(decode(draw(s, o, "stroke", 1)).share(colourful), 0.2);
    o.layer = 3;
    Scene flat;
    add(flat, square(0, 0, 3, 3), {});
    EXPECT_GT(decode(draw(flat, o, "stroke", 1)).share([](Srgb8 c) { return c.b > c.r + 25; }), 0.3);
}

TEST(Pictures, RangesLeaveLayersOut) {
    Scene s;
    for (std::uint32_t k = 0; k < 5; ++k) add(s, line({0, 0, 0.2}, {1, 0, 0.2}, k), {1, 3});
    EXPECT_EQ(s.spans.size(), 3u);
}

TEST(Pictures, RefuseOptionsThatDoNotFit) {
    for (const auto& bad :
         {Options{.view = "0,0,0"}, Options{.view = "1,2"}, Options{.view = "up"}, Options{.regions = "r"}})
        EXPECT_THROW(check(bad), Error);
    EXPECT_NO_THROW(check(Options{.view = "1,-2,0.5"}));
}

TEST(Colour, RampGetsSteadilyLighter) {
    double last = -1;
    for (int k = 0; k <= 100; ++k) {
        const Rgb c = ramp(k / 100.0);
        const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        EXPECT_GT(y, last);
        last = y;
    }
    const Srgb8 grey = to_srgb8(oklch(0.5, 0, 0));
    EXPECT_NEAR(grey.r, grey.g, 1);
    EXPECT_NEAR(grey.g, grey.b, 1);
    EXPECT_EQ(hex(from_srgb8({18, 171, 255})), "#12abff");
}

} // namespace

} // namespace filum::render
