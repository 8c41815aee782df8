#include "stacks.hpp"

namespace filum::link3d {
namespace {

using namespace test;

// Squares of 10 mm, each a stroke of its own, with faces painted at their outlines.
std::vector<RegionPaths> squares(std::uint32_t layers, Join join) {
    std::vector<RegionPaths> out;
    const double in = kWidth / 2;
    for (std::uint32_t i = 0; i < layers; ++i)
        out.push_back(region(i, i, i == 0 ? Join::start : join,
                             {{true, {{in, in}, {10 - in, in}, {10 - in, 10 - in}, {in, 10 - in}}, {kWidth}}}));
    return out;
}

std::vector<Vec2> stroke_starts(const Result& r) {
    std::vector<Vec2> out;
    std::uint32_t stroke = UINT32_MAX;
    for (const Span& s : r.spans)
        if (toolpath::extrudes(s.role) && s.stroke != stroke) {
            out.push_back(s.points.front().xy());
            stroke = s.stroke;
        }
    return out;
}

TEST(SeamPaint, StrokesBeginInTheMiddleOfPaintedFaces) {
    for (const double x : {2.0, 5.0, 7.7}) {
        Options o;
        o.paint = [&](double z) { return z < 0.5 ? SeamPaint{} : SeamPaint{{{{x - 1, 10}, {x + 1, 10}}}, {}}; };
        const Result r = link(squares(5, Join::start), o);
        const auto at = stroke_starts(r);
        ASSERT_EQ(at.size(), 5U);
        for (std::size_t i = 3; i < at.size(); ++i) {
            EXPECT_NEAR(at[i].x, x, kWidth) << i;
            EXPECT_NEAR(at[i].y, 10 - kWidth / 2, 0.01) << i;
        }
        EXPECT_EQ(r.counts.painted, 3U); // layers with their middle at 0.5, 0.7 and 0.9 mm
    }
}

TEST(SeamPaint, NoStrokeBeginsOnFacesPaintedAgainstSeams) {
    Options o;
    o.seam = Seam::back;
    o.paint = [](double) { return SeamPaint{{}, {{{0, 10}, {10, 10}}}}; };
    for (const Vec2 p : stroke_starts(link(squares(4, Join::start), o))) EXPECT_LT(p.y, 10 - kWidth) << p.x;
}

TEST(SeamPaint, LayersThatAStrokePassesAreCounted) {
    Options o;
    o.paint = [](double) { return SeamPaint{{{{4, 10}, {6, 10}}}, {}}; };
    const Result r = link(squares(6, Join::vertical), o);
    EXPECT_EQ(r.counts.strokes, 1U);
    EXPECT_EQ(r.counts.painted, 1U);
    EXPECT_EQ(r.counts.paint_passed, 5U);
    ASSERT_EQ(r.notes.size(), 1U);
    EXPECT_EQ(r.notes[0].code, NoteCode::seam_paint_passed);
}

TEST(SeamPaint, PaintOfAnotherPartDoesNotCount) {
    Options o;
    o.paint = [](double) { return SeamPaint{{{{40, 10}, {60, 10}}}, {}}; };
    const Result r = link(squares(3, Join::start), o), plain = link(squares(3, Join::start));
    EXPECT_EQ(r.counts.painted, 0U);
    for (std::size_t i = 0; i < stroke_starts(r).size(); ++i)
        EXPECT_TRUE(stroke_starts(r)[i] == stroke_starts(plain)[i]);
}

} // namespace
} // namespace filum::link3d
