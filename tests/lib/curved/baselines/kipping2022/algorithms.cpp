// Lines, strokes and lengths that are known beforehand.
#include "base/error.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace filum::baselines::kipping2022 {
namespace {

// As laid, without smoothing, by default.
using surfpath::Algorithm;

Options options(Algorithm algorithm, double spacing = 1) {
    Options o;
    o.algorithm = algorithm;
    o.spacing = spacing;
    o.window = 1;
    return o;
}

std::string refused(const surface::Sheet& sheet, const Options& o, Exit exit) {
    try {
        plan(sheet, o);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), exit) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "did not refuse";
    return "";
}

// Whether two stretches of the plan that do not follow each other cross, seen from above.
std::size_t crossings(const surfpath::plan::Plan& plan) {
    std::vector<std::pair<Vec2, Vec2>> all;
    for (const auto& stroke : plan.strokes)
        for (const auto& piece : stroke.sections)
            for (std::size_t i = 1; i < piece.line.size(); ++i)
                all.emplace_back(piece.line[i - 1].xy(), piece.line[i].xy());
    std::size_t out = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = i + 2; k < all.size(); ++k) {
            const auto& [a, b] = all[i];
            const auto& [c, d] = all[k];
            if (orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0) ++out;
        }
    return out;
}

TEST(Fina, RowsOfARectangleAreOnePathWithAGapOf2DAtTheSeed) {
    const auto sheet = measured(rectangle(21, 10), "plane:1,0,0,10.5");
    const auto out = plan(sheet, options(Algorithm::fina));
    ASSERT_EQ(out.strokes.size(), 1U);
    EXPECT_EQ(fact(out, "pieces"), 20);
    EXPECT_NEAR(length(out), 20 * 10 + 2 * 9 * 1 + 2, 0.01);
    for (const auto& p : out.strokes[0].sections[0].line.places) {
        const double away = std::abs(p.point.x - 10.5);
        if (p.point.y > 0.01 && p.point.y < 9.99) {
            EXPECT_NEAR(away, std::round(away), 1e-6);
        }
    }
    EXPECT_TRUE(out.notes.empty());
}

TEST(Fina, OnlyOneHalfIfTheSeedIsARim) {
    const auto out = plan(measured(rectangle(21, 10), "plane:1,0,0,0"), options(Algorithm::fina, 2));
    ASSERT_EQ(out.strokes.size(), 1U);
    EXPECT_NEAR(length(out), 10 * 10 + 9 * 2, 0.01);
}

TEST(Fexa, TravelsOverAHoleWhereverARowMeetsIt) {
    auto sheet = measured(holed(15.5, 5.3), "plane:1,0,0,0");
    const auto out = plan(sheet, options(Algorithm::fexa));
    EXPECT_EQ(fact(out, "pieces"), 2 * (15 + 5)); // 15 rows a side, 5 of them in two pieces
    EXPECT_EQ(out.strokes.size(), 1U + 2 * 5);
    EXPECT_EQ(crossings(out), 0U);
    sheet.fields.clear(), sheet.sources = {};
    Options named = options(Algorithm::fexa);
    named.plane = surface::Plane{{2, 0, 0}, 0};
    const auto same = plan(sheet, named);
    ASSERT_EQ(same.strokes.size(), out.strokes.size());
    EXPECT_NEAR(length(same), length(out), 1e-6);
}

// On a cylinder that lies on its side, rows that are equally far from a plane in space bunch on the surface.
TEST(Fexa, SpacingOnTheSurfaceIsNotKeptButThatOfFinaIs) {
    const auto half = [](double u, double v) { // radius 10, from the top down to both sides by 80 degrees
        const double a = (2 * u - 1) * 80 * pi / 180;
        return Vec3{10 * std::sin(a), 20 * v, 10 * std::cos(a)};
    };
    const auto sheet = measured(grid(80, 20, half), "plane:1,0,0,0");
    EXPECT_EQ(fact(plan(sheet, options(Algorithm::fina)), "pieces"), 2 * 13); // arcs up to 13.96
    EXPECT_EQ(fact(plan(sheet, options(Algorithm::fexa)), "pieces"), 2 * 9);  // sines up to 9.85
}

TEST(Ortheo, LinesAcrossARectangle) {
    const auto out = plan(measured(rectangle(20.5, 10), "plane:0,1,0,0"), options(Algorithm::ortheo));
    ASSERT_EQ(out.strokes.size(), 21U); // ceil(20.5)
    EXPECT_EQ(fact(out, "insertions"), 0);
    for (const auto& stroke : out.strokes) EXPECT_GT(length(stroke), 8.99);
}

TEST(Ortheo, BothSidesOfASeedCurveInside) {
    const auto out = plan(measured(rectangle(20.5, 11), "plane:0,1,0,5.5"), options(Algorithm::ortheo));
    EXPECT_EQ(out.strokes.size(), 42U);
}

// Lines grow in the middle only, where the seed curve is; a note reports the area beside them.
TEST(Ortheo, NotesWhatLiesBesideItsLines) {
    surface::Sheet sheet = measured(rectangle(20, 10), "plane:0,1,0,0");
    EXPECT_TRUE(plan(sheet, options(Algorithm::ortheo)).notes.empty());
    std::erase_if(sheet.sources.segments, [](const surface::Segment& s) { return std::max(s.a.x, s.b.x) > 10; });
    const auto out = plan(sheet, options(Algorithm::ortheo));
    EXPECT_EQ(out.strokes.size(), 10U);
    double bare = 0;
    for (const auto& note : out.notes) bare += note.amount;
    EXPECT_NEAR(bare, 9 * (20 - 10), 9 * 0.5); // the last line is at 9, and counts for 1 more
}

// Across a ring: the number of lines follows its circumference, except where it halves or doubles at once.
TEST(Ortheo, InsertsWhereLinesPartAndEndsWhereTheyMeet) {
    const auto lines = [](double from, double to, const char* rim) {
        return plan(measured(zone(5, from, to), rim), options(Algorithm::ortheo, 0.5));
    };
    const auto first = [](const surfpath::plan::Plan& p) {
        return static_cast<double>(p.strokes.size()) - fact(p, "insertions");
    };
    auto outwards = lines(0.5, 1.2, "boundary:0"); // from 15.06 mm to 29.28 mm
    if (first(outwards) > 31) outwards = lines(0.5, 1.2, "boundary:1");
    EXPECT_EQ(first(outwards), 30); // the 31st is 0.06 mm from the first one and goes nowhere
    EXPECT_NEAR(fact(outwards, "insertions"), 31, 1);
    EXPECT_EQ(fact(outwards, "endings"), 1);
    auto inwards = lines(0.25, 1.2, "boundary:0"); // from 29.28 mm to 7.77 mm
    if (first(inwards) < 58) inwards = lines(0.25, 1.2, "boundary:1");
    EXPECT_NEAR(first(inwards), 58, 1);
    EXPECT_LE(fact(inwards, "insertions"), 1); // beside the last one
    EXPECT_GE(fact(inwards, "endings"), 29);   // half of them; more where marching drifts
    EXPECT_LE(fact(inwards, "endings"), 40);
}

TEST(GeoFiso, IsOnePathThatCrossesNowhere) {
    const auto sheet = measured(rectangle(30, 13), "boundary");
    const auto out = plan(sheet, options(Algorithm::geo_fiso));
    EXPECT_EQ(fact(out, "contours"), 6);
    EXPECT_EQ(fact(out, "reroutings"), 5);
    ASSERT_EQ(out.strokes.size(), 1U);
    EXPECT_EQ(crossings(out), 0U);
    double rings = 0;
    for (int i = 1; i <= 6; ++i) rings += 2 * (30 + 13 - 4 * i);
    EXPECT_NEAR(length(out), rings, 10); // each rerouting: 1 mm left out twice, 2 mm across
    const auto holes = plan(measured(holed(15.4, 5), "boundary"), options(Algorithm::geo_fiso));
    EXPECT_EQ(holes.strokes.size(), 1U);
    EXPECT_EQ(crossings(holes), 0U);
}

TEST(GeoFiso, LeavesTheVoidAtTheMaximumThatThePaperTellsOf) {
    const auto out = plan(measured(rectangle(30, 13.8), "boundary"), options(Algorithm::geo_fiso));
    double nearest = 1e9; // to the medial axis at y = 6.9, where the last ring is 0.9 away
    for (const auto& p : out.strokes[0].sections[0].line.places)
        if (p.point.x > 10 && p.point.x < 20) nearest = std::min(nearest, std::abs(p.point.y - 6.9));
    EXPECT_GT(nearest, 0.8);
}

TEST(GeoContour, WindsIntoTheMaximum) {
    const auto out = plan(measured(rectangle(30, 13.8), "boundary"), options(Algorithm::geo_contour));
    EXPECT_EQ(fact(out, "spirals"), 1);
    EXPECT_EQ(fact(out, "maxima"), 1);
    EXPECT_EQ(fact(out, "rerouting-contours"), 0);
    ASSERT_EQ(out.strokes.size(), 1U);
    EXPECT_EQ(crossings(out), 0U);
    const auto& places = out.strokes[0].sections[0].line.places;
    const Vec3 first = places.front().point;
    EXPECT_NEAR(std::min({first.x, 30 - first.x, first.y, 13.8 - first.y}), 1, 1e-6);
    EXPECT_NEAR(places.back().point.y, 6.9, 0.2); // vertices within 0.1 d of the greatest distance
}

TEST(GeoContour, PartsAtContoursOfMoreThanTwoNeighbours) {
    // two rooms of 13 mm with a door of 7 mm
    const auto rooms = [](double u, double v) {
        const double x = 40 * u - 20, open = std::abs(x) < 4 ? 3.5 : std::min(6.5, 3.5 + std::abs(x) - 4);
        return Vec3{x, (2 * v - 1) * open, 0};
    };
    const auto out = plan(measured(grid(80, 26, rooms), "boundary"), options(Algorithm::geo_contour));
    EXPECT_EQ(fact(out, "rerouting-contours"), 1); // the innermost one that goes through the door
    EXPECT_EQ(fact(out, "maxima"), 2);
    EXPECT_EQ(out.strokes.size(), 4U); // outside in, two rooms, and that contour
    EXPECT_EQ(crossings(out), 0U);
    const auto fiso = plan(measured(grid(80, 26, rooms), "boundary"), options(Algorithm::geo_fiso));
    EXPECT_EQ(fiso.strokes.size(), 1U);
}

TEST(GeoSpiral, WindsOncePerLevelAndStopsWhereTheyFallApart) {
    const auto round = plan(measured(zone(40, 1e-4, 0.29), "point:0,0,40"), options(Algorithm::geo_spiral));
    ASSERT_EQ(round.strokes.size(), 1U);
    EXPECT_EQ(fact(round, "levels-laid"), 11); // an arc of 11.6 mm
    double rings = 0;
    for (int i = 1; i <= 11; ++i) rings += 2 * pi * 40 * std::sin(i / 40.0);
    EXPECT_NEAR(length(round), rings, 11 * 1.1); // a step between levels, and across it
    // in a long rectangle, rings fall into two arcs
    const auto sheet = measured(rectangle(60, 9.5), "point:30,4.75,0");
    const auto out = plan(sheet, options(Algorithm::geo_spiral));
    EXPECT_EQ(fact(out, "levels-laid"), 4);
    double left = 0;
    for (const auto& note : out.notes)
        if (note.code == NoteCode::isocontour_beyond) left += note.amount;
    EXPECT_GT(left, 25 * 2 * 9.5);
    // near a rim they become arcs, which go on back and forth
    const auto corner = plan(measured(rectangle(30, 30), "point:0,0,0"), options(Algorithm::geo_spiral));
    EXPECT_GE(fact(corner, "levels-laid"), 29);
    EXPECT_EQ(corner.strokes.size(), 1U);
    EXPECT_EQ(crossings(corner), 0U);
}

// The fault that the paper names; it must stay measurable.
TEST(Smoothing, TakesThePathOffCurvedSurfaces) {
    const auto sheet = measured(zone(3, 0.2, 1.4), "boundary");
    const auto farthest = [&](const Options& o) {
        double out = 0;
        for (const auto& stroke : plan(sheet, o).strokes)
            for (const auto& p : stroke.sections[0].line.places)
                out = std::max(out, distance(p.point, surface::nearest_in(sheet.surface, p.triangle, p.point)));
        return out;
    };
    Options o = options(Algorithm::geo_fiso, 0.5);
    EXPECT_LT(farthest(o), 0.02); // chords
    o.window = 15;
    o.degree = 1;
    EXPECT_GT(farthest(o), 0.05);
}

TEST(Refusals, SayWhatIsMissing) {
    surface::Sheet bare{rectangle(10, 10), {}, {}, {}};
    for (const Algorithm a :
         {Algorithm::fina, Algorithm::ortheo, Algorithm::geo_fiso, Algorithm::geo_contour, Algorithm::geo_spiral})
        EXPECT_NE(refused(bare, options(a), Exit::bad_input).find("run geodesic"), std::string::npos);
    const auto rims = measured(rectangle(10, 10), "boundary");
    EXPECT_NE(refused(measured(zone(10, 0.3, 1), "boundary"), options(Algorithm::fina), Exit::usage).find("--plane"),
              std::string::npos);
    EXPECT_NE(refused(rims, options(Algorithm::geo_spiral), Exit::usage).find("seed point"), std::string::npos);
    EXPECT_NE(refused(rims, options(Algorithm::geo_fiso, 6), Exit::usage).find("lower --spacing"), std::string::npos);
    EXPECT_NE(refused(rims, options(Algorithm::geo_fiso, 1e-6), Exit::usage).find("raise --spacing"),
              std::string::npos);
    const auto row = measured(rectangle(10, 10), "plane:1,0,0,5");
    EXPECT_NE(refused(row, options(Algorithm::geo_contour), Exit::usage).find("--source boundary"), std::string::npos);
    EXPECT_NE(refused(row, options(Algorithm::fexa, 7), Exit::usage).find("lower --spacing"), std::string::npos);
    EXPECT_NE(refused(measured(rectangle(10, 10), "vertex:0"), options(Algorithm::ortheo), Exit::bad_input)
                  .find("seed curve"),
              std::string::npos);
    Options even = options(Algorithm::fina);
    even.window = 4;
    EXPECT_NE(refused(row, even, Exit::usage).find("odd"), std::string::npos);
    even.window = 3;
    even.degree = 3;
    EXPECT_NE(refused(row, even, Exit::usage).find("--savgol-degree"), std::string::npos);
}

TEST(Refusals, ClosedSurfacesHaveNoRimToBeginAt) {
    mesh::Mesh cube;
    for (int i = 0; i < 8; ++i) cube.vertices.push_back({10.0 * (i & 1), 10.0 * (i >> 1 & 1), 10.0 * (i >> 2 & 1)});
    cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    Notes notes;
    const auto sheet = measured(surface::connect(cube, notes), "vertex:0");
    EXPECT_NE(refused(sheet, options(Algorithm::geo_fiso), Exit::bad_input).find("closed"), std::string::npos);
    EXPECT_EQ(plan(sheet, options(Algorithm::geo_spiral)).strokes.size(), 1U);
}

TEST(Components, WithoutASourceAreNotedWithTheirArea) {
    auto two = [] {
        mesh::Mesh m;
        for (const double x : {0.0, 100.0})
            for (const Vec3& p : {Vec3{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}})
                m.vertices.push_back(p + Vec3{x, 0, 0});
        m.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
        Notes notes;
        return surface::connect(m, notes);
    }();
    const auto out = plan(measured(two, "plane:1,0,0,5"), options(Algorithm::fina));
    ASSERT_EQ(out.notes.size(), 1U);
    EXPECT_DOUBLE_EQ(out.notes[0].amount, 100);
    EXPECT_EQ(unit(out.notes[0]), "mm2");
}

TEST(Components, HaveATreeEach) {
    mesh::Mesh m;
    for (const double x : {0.0, 100.0}) {
        const Surface s = rectangle(20, 9);
        const auto first = static_cast<std::uint32_t>(m.vertices.size());
        for (const Vec3& p : s.vertices) m.vertices.push_back(p + Vec3{x, 0, 0});
        for (const auto& t : s.triangles) m.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    Notes notes;
    const auto out = plan(measured(surface::connect(m, notes), "boundary"), options(Algorithm::geo_fiso));
    ASSERT_EQ(out.strokes.size(), 2U);
    EXPECT_NEAR(length(out.strokes[0]), length(out.strokes[1]), 1e-6);
}

} // namespace
} // namespace filum::baselines::kipping2022
