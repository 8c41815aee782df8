#include "fill/rings/lanes.hpp"

#include "../../../trials.hpp"
#include "../../fill/pattern_check.hpp"
#include "fill/rings/fewer_points.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <numbers>
#include <random>

namespace filum::fill::rings {
namespace {

using test::Loops;
using toolpath::Curve;

constexpr double kWidth = 0.4;

// The region with every point (x, y) at (a x + b y, c x + d y); the order is kept up where that mirrors.
Loops mapped(const Loops& region, double a, double b, double c, double d) {
    Loops out;
    for (std::size_t l = 0; l < region.size(); ++l) {
        std::vector<Vec2> loop;
        for (const Vec2 p : region[l]) loop.push_back({a * p.x + b * p.y, c * p.x + d * p.y});
        if (a * d - b * c < 0) std::reverse(loop.begin(), loop.end());
        out.add(loop);
    }
    return out;
}

// Each edge in `parts`.
Loops divided(const Loops& region, int parts) {
    Loops out;
    for (std::size_t l = 0; l < region.size(); ++l) {
        std::vector<Vec2> loop;
        for (std::size_t i = 0; i < region[l].size(); ++i)
            for (int k = 0; k < parts; ++k)
                loop.push_back(
                    geom::lerp(region[l][i], region[l][(i + 1) % region[l].size()], static_cast<double>(k) / parts));
        out.add(loop);
    }
    return out;
}

std::vector<Loops> many_regions() {
    std::vector<Loops> out;
    for (unsigned seed = 0; seed < 30; ++seed)
        for (const Loops& r : test::random_regions(seed)) out.push_back(r);
    for (const auto& [name, r] : test::hard_regions()) out.push_back(r);
    return out;
}

TEST(Lanes, AreClosedRingsInsideThatCrossNothing) {
    for (const Loops& region : many_regions()) {
        const auto all = curves_of(lanes(region, {.width = kWidth}));
        ASSERT_FALSE(all.empty());
        test::expect_sound(all);
        EXPECT_EQ(test::crossings(all), 0U);
        EXPECT_LT(test::farthest_outside(region, all), 0.011);
    }
}

// Except for corners, where each ring reaches a little too far, and hairs, which are thinner than any bead.
TEST(Lanes, ShareTheRegion) {
    for (const Loops& region : many_regions()) {
        double outline = 0;
        for (std::size_t l = 0; l < region.size(); ++l)
            for (std::size_t i = 0; i < region[l].size(); ++i)
                outline += geom::distance(region[l][i], region[l][(i + 1) % region[l].size()]);
        const double area = polygon::signed_area(region), laid = laid_area(lanes(region, {.width = kWidth}));
        EXPECT_NEAR(laid, area, 0.1 * area + 0.05 * kWidth * outline);
    }
}

TEST(Lanes, AreNeverWiderThanTwiceAndWhereTheyRunAsWideAsTheWallAsks) {
    for (double wall = 0.1; wall < 6; wall += kSanitized ? 0.97 : 0.17) {
        const Loops bar = test::rectangle(0, 0, 60, wall);
        const Rings all = lanes(bar, {.width = kWidth});
        const auto n = std::max(1L, std::lround(wall / (2 * kWidth))); // a side; one lane more or less between
        for (const double w : all.width) EXPECT_LE(w, 2 * kWidth) << wall;
        EXPECT_NEAR(static_cast<double>(all.size()), static_cast<double>(n), 1) << wall;
        EXPECT_GT(test::coverage(bar, curves_of(all), 0.02), 0.98) << wall;
    }
}

TEST(Lanes, TheFirstOneEndsInNoNeck) { // that widens as corners do
    for (const double half : {0.15, 0.05, 0.01}) {
        Loops hourglass;
        hourglass.add(std::vector<Vec2>{{-3, -3}, {0, -half}, {3, -3}, {3, 3}, {0, half}, {-3, 3}});
        EXPECT_EQ(lanes(hourglass, {.width = kWidth, .most = 1}).size(), 1U) << half;
    }
}

// An arm thinner than half a bead, and ever thinner, that leaves a wall by steps as steep as a corner's.
TEST(Lanes, TheFirstOneRunsIntoThinArms) {
    for (const double turn : {0.0, 0.4, 0.8})
        for (const double end : {0.26, 0.2, 0.1}) {
            const auto at = [&](double x, double y) {
                return Vec2{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
            };
            Loops arm;
            arm.add(std::vector<Vec2>{at(0, -0.13), at(16, -end / 2), at(16, end / 2), at(0, 0.13)});
            const Loops region = polygon::unite(test::rectangle(-0.4, -8, 0.38, 3), arm);
            ASSERT_EQ(region.size(), 1U);
            EXPECT_GT(test::coverage(region, curves_of(lanes(region, {.width = kWidth})), 0.02), 0.98)
                << turn << " " << end;
        }
}

// A corner of the outline beside an arm thinner than a bead: the lane goes round it no deeper than it runs, not to the
// middle of the arm and back.
TEST(Lanes, DoNotTurnBackAtTheSidesOfArms) {
    for (const double radius : {0.6, 0.9, 1.3, 2.0})
        for (const int arms : {3, 4, 5, 7, 9})
            for (const double wave : {0.2, 0.35, 0.5}) {
                std::vector<Vec2> star;
                for (int i = 0; i < 150; ++i) {
                    const double a = 2 * std::numbers::pi * i / 150, r = radius * (1 + wave * std::sin(arms * a));
                    star.push_back({r * std::cos(a), r * std::sin(a)});
                }
                Loops region;
                region.add(star);
                int back = 0;
                for (const Curve& c : curves_of(lanes(region, {.width = 0.9, .most = 1})))
                    for (std::size_t i = 0, n = c.points.size(); i < n; ++i) {
                        const Vec2 u = c.points[(i + 1) % n] - c.points[i],
                                   v = c.points[(i + 2) % n] - c.points[(i + 1) % n];
                        back += dot(u, v) < -0.5 * geom::norm(u) * geom::norm(v) ? 1 : 0;
                    }
                EXPECT_LE(back, 3 * arms) << radius << " " << arms << " " << wave; // some, at tips
            }
}

TEST(Lanes, FromTheOutlineAreTheFirstOfAll) {
    const Loops region = test::random_regions(5).at(0);
    const Rings all = lanes(region, {.width = kWidth}), two = lanes(region, {.width = kWidth, .most = 2});
    ASSERT_LT(two.size(), all.size());
    EXPECT_EQ(two.lane.back(), 2);
    EXPECT_TRUE(std::is_sorted(all.lane.begin(), all.lane.end()));
    EXPECT_EQ(two.points, std::vector<Vec2>(all.points.begin(), all.points.begin() + two.start.back()));
}

// Where a wall is just as thick as decides between two numbers of lanes, rounding decides: that moves a little material
// in a shape now and then, and next to nothing in all.
TEST(Lanes, DoNotDependOnHowTheRegionLiesOrIsDivided) {
    double all = 0, off = 0;
    for (unsigned seed = 0; seed < 12; ++seed)
        for (const Loops& region : test::random_regions(seed)) {
            const double area = polygon::signed_area(region), plain = laid_area(lanes(region, {.width = kWidth}));
            const Loops others[] = {mapped(region, -1, 0, 0, 1), mapped(region, 0, -1, 1, 0),
                                    mapped(region, 0.8, -0.6, 0.6, 0.8), divided(region, 7)};
            for (const Loops& other : others) {
                const double difference = std::abs(laid_area(lanes(other, {.width = kWidth})) - plain);
                EXPECT_LT(difference, 0.01 * area + 0.001) << seed;
                all += area;
                off += difference;
            }
        }
    EXPECT_LT(off, 0.001 * all);
}

TEST(Lanes, ScaleWithTheBead) {
    const Loops region = test::random_regions(7).at(0);
    for (const double by : {0.5, 2.0, 20.0}) {
        const Loops scaled = mapped(region, by, 0, 0, by);
        const auto all = curves_of(lanes(scaled, {.width = by * kWidth}));
        EXPECT_EQ(test::crossings(all), 0U);
        EXPECT_NEAR(test::laid(all) / polygon::signed_area(scaled), 1, 0.05) << by;
    }
}

TEST(Lanes, OfANoisyOutlineAreSoundAndFew) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> noise(-0.02, 0.02);
    std::vector<Vec2> loop;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n, r = 30 + noise(random);
        loop.push_back({r * std::cos(a), r * std::sin(a)});
    }
    const auto all = curves_of(lanes(test::loop(loop), {.width = kWidth}));
    EXPECT_EQ(test::crossings(all), 0U);
    EXPECT_NEAR(test::laid(all) / (std::numbers::pi * 900), 1, 0.01);
}

// With fewer lanes than there is room for: their beads and the rest are the region, except corners and hairs.
TEST(FirstLanes, LeaveTheRestOfTheRegion) {
    for (const Loops& region : many_regions())
        for (const int n : {1, 2, 5}) {
            const FirstLanes f = first_lanes(region, {.width = kWidth, .most = n});
            EXPECT_EQ(f.lanes.points, lanes(region, {.width = kWidth, .most = n}).points);
            double outline = 0, rest = 0;
            for (std::size_t l = 0; l < region.size(); ++l) outline += polygon::perimeter(region[l]);
            for (const Loops& part : f.rest) rest += polygon::signed_area(part);
            const double area = polygon::signed_area(region);
            EXPECT_NEAR(laid_area(f.lanes) + rest, area, 0.1 * area + 0.05 * kWidth * outline) << n;
        }
}

TEST(FirstLanes, LeaveSimplePartsThatAnotherPatternFillsWithoutCrossingThem) {
    for (const Loops& region : many_regions())
        for (const int n : {1, 3}) {
            const FirstLanes f = first_lanes(region, {.width = kWidth, .most = n});
            auto all = curves_of(f.lanes);
            for (const Loops& part : f.rest) {
                EXPECT_TRUE(polygon::is_simple(part));
                EXPECT_GT(polygon::signed_area(part[0]), 0);
                for (std::size_t l = 1; l < part.size(); ++l) EXPECT_LT(polygon::signed_area(part[l]), 0);
                for (const Vec2 p : part.points) EXPECT_TRUE(polygon::contains(region, p));
                for (const Vec2 p : f.lanes.points) EXPECT_FALSE(polygon::contains(part, p)) << p.x << ' ' << p.y;
                for (const Curve& c : curves_of(lanes(part, {.width = kWidth, .tolerance = 0.01 / 16})))
                    all.push_back(c);
            }
            std::size_t of_themselves = 0; // hair tips of rings, which the fill lays anew
            for (const Curve& c : all) of_themselves += test::crossings({c});
            EXPECT_EQ(test::crossings(all), of_themselves);
            EXPECT_LE(of_themselves, 1U);
        }
}

TEST(FirstLanes, LeaveTheRegionSmallerByTheirWidth) {
    const double w = kWidth;
    const FirstLanes bar = first_lanes(test::rectangle(0, 0, 60, 10), {.width = w, .most = 3});
    ASSERT_EQ(bar.rest.size(), 1U);
    EXPECT_NEAR(polygon::signed_area(bar.rest[0]), (60 - 6 * w) * (10 - 6 * w), 0.7); // beads overlap a little
    Loops plate = test::rectangle(0, 0, 40, 30);
    plate.add(std::vector<Vec2>{{10, 10}, {10, 20}, {20, 20}, {20, 10}});
    const FirstLanes holed = first_lanes(plate, {.width = w, .most = 2});
    ASSERT_EQ(holed.rest.size(), 1U);
    ASSERT_EQ(holed.rest[0].size(), 2U);
    EXPECT_NEAR(-polygon::signed_area(holed.rest[0][1]), 100 + 40 * 2 * w + std::numbers::pi * 4 * w * w, 0.2);
    EXPECT_TRUE(first_lanes(test::rectangle(0, 0, 60, 4 * w), {.width = w, .most = 2}).rest.empty());
    EXPECT_TRUE(first_lanes(plate, {.width = w}).rest.empty());
}

TEST(FewerPoints, StayAsNearOnEitherSide) {
    Curve circle{true, {}, {}};
    for (int i = 0; i < 720; ++i) {
        const double a = 2 * std::numbers::pi * i / 720;
        circle.points.push_back({10 * std::cos(a), 10 * std::sin(a)});
        circle.width.push_back(kWidth);
    }
    const Curve few = with_fewer_points(circle, 0.01, 0.016, true);
    EXPECT_LE(few.points.size(), 52U); // chords of the root of 8 * 0.02 * 10 mm: every fourteenth point
    for (std::size_t i = 0; i < few.points.size(); ++i) { // chords alone would be 0.02 inside at their middle
        const Vec2 p = few.points[i], q = few.points[(i + 1) % few.points.size()];
        EXPECT_NEAR(geom::norm(p), 10, 0.0101);
        EXPECT_NEAR(geom::norm(geom::lerp(p, q, 0.5)), 10, 0.0125); // where the last chord is shorter
    }
}

// A plate with corners as rounding leaves them, begun anywhere: of as many turns the sum of squares is the least where
// all are the same.
TEST(FewerPoints, TurnEvenly) {
    constexpr int kStarts = 40;
    const Vec2 corner[] = {{5, 5}, {-5, 5}, {-5, -5}, {5, -5}};
    double squares = 0;
    for (int first = 0; first < kStarts; ++first) {
        Curve plate{true, {}, {}};
        for (int i = 0; i < 160; ++i) {
            const int at = (i + first) % 160, q = at / 40;
            const Vec2 p = corner[q], u = 0.032 * (corner[(q + 3) % 4] - p), v = 0.032 * (corner[(q + 1) % 4] - p);
            const double t = (at % 40 + 0.5) / 40;
            plate.points.push_back(p + (1 - t) * (1 - t) * u + t * t * v);
            plate.width.push_back(kWidth);
        }
        const Curve few = with_fewer_points(plate, 0.01, 0.016, true);
        const std::size_t n = few.points.size();
        EXPECT_LE(n, 17U) << first;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 u = few.points[i] - few.points[(i + n - 1) % n], v = few.points[(i + 1) % n] - few.points[i];
            const double turn = std::atan2(cross(u, v), dot(u, v));
            squares += turn * turn / kStarts;
        }
    }
    EXPECT_LT(squares, 3.75); // 3.82 where each chord runs as far as it can
}

// A disc whose outline has `count` points in waves, with a wavy hole.
Loops wavy_disc(std::size_t count, double radius, double hole, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> depth(0.1, 0.6), length(0.7, 3);
    Loops out;
    for (const double r : {radius, -hole}) {
        const double d = depth(random), waves = std::round(2 * std::numbers::pi * std::abs(r) / length(random));
        std::vector<Vec2> loop;
        for (std::size_t k = 0; k < count; ++k) {
            const double t = (r > 0 ? 2 : -2) * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
            const double at = std::abs(r) + d * std::sin(waves * t);
            loop.push_back({at * std::cos(t), at * std::sin(t)});
        }
        if (r != 0) out.add(loop);
    }
    return out;
}

// Lanes are traced in groups, on several threads: which ones, depends on how many lanes there are.
TEST(Lanes, OfLargeRegionsDoNotDependOnTheirGroups) {
    std::mt19937 random(7);
    std::uniform_int_distribution<std::size_t> points(1500, 9000);
    for (unsigned seed = 0; seed < 12; ++seed) {
        const std::size_t n = points(random);
        const double radius = 0.004 * static_cast<double>(n);
        const Loops region = wavy_disc(n, radius, seed % 2 == 0 ? 0 : radius / 3, seed);
        const Rings all = lanes(region, {.width = kWidth});
        ASSERT_GT(all.size(), 10U);
        EXPECT_TRUE(std::is_sorted(all.lane.begin(), all.lane.end()));
        for (const int most : {1, 2, 3, 7, 20}) {
            const Rings some = lanes(region, {.width = kWidth, .most = most});
            const auto rings =
                static_cast<std::size_t>(std::upper_bound(all.lane.begin(), all.lane.end(), most) - all.lane.begin());
            ASSERT_EQ(some.size(), rings) << seed;
            EXPECT_TRUE(std::equal(some.points.begin(), some.points.end(), all.points.begin())) << seed << ' ' << most;
            EXPECT_TRUE(std::equal(some.width.begin(), some.width.end(), all.width.begin())) << seed << ' ' << most;
        }
    }
}

TEST(FewerPoints, KeepWhatIsLaid) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const Loops& region : test::random_regions(seed)) {
            const Rings all = lanes(region, {.width = kWidth, .tolerance = 0.0025});
            Rings few;
            for (const Curve& ring : curves_of(all))
                few.add(with_fewer_points(ring, 0.01, least_void(kWidth, polygon::signed_area(region)), false), 1);
            EXPECT_LE(few.points.size(), all.points.size());
            EXPECT_NEAR(laid_area(few) / laid_area(all), 1, 0.01) << seed;
        }
}

TEST(FewerPoints, DivideALongChangeOfWidth) {
    const Curve taper{true, {{0, 0}, {10, 0}, {10, 1}, {0, 1}}, {0.2, 0.8, 0.8, 0.2}};
    const Curve out = with_fewer_points(taper, 0.01, 0.016, true);
    EXPECT_EQ(out.points.size(), 12U); // five parts there and back: sqrt(0.6 * 10 / 16 / 0.016) = 4.8
    for (std::size_t i = 0; i < out.points.size(); ++i)
        EXPECT_NEAR(out.width[i], 0.2 + 0.06 * out.points[i].x, 1e-9) << i;
}

} // namespace
} // namespace filum::fill::rings
