#include "plate/plate.hpp"
#include "geom/hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace filum;
using geom::Vec2;

plate::Thing random_thing(std::mt19937& random) {
    std::uniform_real_distribution<double> size(5, 40), height(2, 60);
    const double w = size(random), d = size(random);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k) points.push_back({w * share(random) - 100, d * share(random) + 50});
    return {geom::convex_hull(points), height(random)};
}

std::vector<Vec2> moved(std::vector<Vec2> points, const plate::Place& place) {
    for (Vec2& p : points) p = place(p);
    return points;
}

// Whether a box of half the sizes x and y, run along the outline of a, keeps off that of b: no edge of either parts
// them otherwise than their grown hulls do.
bool apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double x, double y) {
    std::vector<Vec2> grown;
    for (const Vec2& p : a)
        for (const Vec2 by : {Vec2{x, y}, Vec2{-x, y}, Vec2{x, -y}, Vec2{-x, -y}}) grown.push_back(p + by);
    grown = geom::convex_hull(grown);
    // two convex polygons are apart where an edge of one has all of the other on its outer side
    const auto parts = [](const std::vector<Vec2>& one, const std::vector<Vec2>& other) {
        for (std::size_t i = 0; i < one.size(); ++i) {
            const Vec2 from = one[i], to = one[(i + 1) % one.size()];
            if (std::all_of(other.begin(), other.end(), [&](Vec2 p) { return geom::orient(from, to, p) <= 1e-9; }))
                return true;
        }
        return false;
    };
    return parts(grown, b) || parts(b, grown);
}

TEST(Plate, PartsKeepTheAskedDistanceAndLieOnTheBed) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        std::mt19937 random(seed);
        std::vector<plate::Thing> things;
        for (int k = 0; k < 3 + static_cast<int>(seed); ++k) things.push_back(random_thing(random));
        const plate::Spacing apart_by{5.0 + seed % 3, 8, false};
        const Vec2 size{260, 240};
        const plate::Packing packed = plate::pack(things, apart_by, size);
        ASSERT_TRUE(packed.left.empty()) << seed;
        geom::Box2 box;
        for (std::size_t i = 0; i < things.size(); ++i) {
            const auto own = moved(things[i].outline, packed.place[i]);
            for (const Vec2& p : own) box.add(p);
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_TRUE(
                    apart(own, moved(things[j].outline, packed.place[j]), apart_by.x - 0.005, apart_by.y - 0.005))
                    << seed << ": " << i << " and " << j;
        }
        EXPECT_LE(box.hi.x - box.lo.x, size.x);
        EXPECT_LE(box.hi.y - box.lo.y, size.y);
        EXPECT_NEAR(box.lo.x + box.hi.x, 0, 0.01);
        EXPECT_EQ(plate::pack(things, apart_by, size).place, packed.place); // the same again
    }
}

// Copies of one part stand in rows. All keep their distance, and as many fit as area and shape allow.
TEST(Plate, CopiesStandInRows) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 random(seed);
        const plate::Thing thing = random_thing(random);
        const std::vector<plate::Thing> things(2 + seed * 3, thing);
        const plate::Spacing by{2.0 + seed % 3, 2.0 + seed % 4, false};
        const Vec2 size{400, 380};
        const plate::Packing packed = plate::pack(things, by, size);
        if (!packed.left.empty()) continue;
        geom::Box2 box;
        std::vector<std::vector<Vec2>> own;
        for (std::size_t i = 0; i < things.size(); ++i) {
            EXPECT_EQ(packed.place[i].quarters, 0);
            own.push_back(moved(thing.outline, packed.place[i]));
            for (const Vec2& p : own[i]) box.add(p);
        }
        for (std::size_t i = 0; i < things.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_TRUE(norm(packed.place[i].move - packed.place[j].move) > 100 ||
                            apart(own[i], own[j], by.x - 0.005, by.y - 0.005))
                    << seed << ": " << i << ", " << j;
        EXPECT_LE(box.hi.x - box.lo.x, size.x);
        EXPECT_LE(box.hi.y - box.lo.y, size.y);
    }
}

TEST(Plate, DiscsStandLikeAHoneycomb) {
    std::vector<Vec2> disc;
    for (int k = 0; k < 360; ++k) disc.push_back({5 * std::cos(k * 0.0174532925), 5 * std::sin(k * 0.0174532925)});
    // in a square of 100 mm: 100 in a grid, 105 as a honeycomb
    EXPECT_TRUE(plate::pack(std::vector<plate::Thing>(105, {disc, 5}), {0, 0, false}, {100.1, 100.1}).left.empty());
    const auto refused = plate::pack(std::vector<plate::Thing>(500, {disc, 5}), {0, 0, false}, {100.1, 100.1});
    EXPECT_EQ(refused.left.size(), 395U); // decided by area, without a search
}

TEST(Plate, APartAsLargeAsTheBedFitsAndASecondOneIsLeft) {
    const std::vector<Vec2> square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    std::vector<plate::Thing> things{{square, 10}};
    EXPECT_TRUE(plate::pack(things, {5, 5, true}, {100.1, 100.1}).left.empty());
    things.push_back({{{0, 0}, {10, 0}, {10, 10}}, 10});
    EXPECT_EQ(plate::pack(things, {5, 5, true}, {100.1, 100.1}).left, std::vector<std::size_t>{1});
    EXPECT_TRUE(plate::pack(things, {5, 5, true}, {115.1, 100.1}).left.empty());
}

// Three of 95 x 60 fit on 200 x 100 upright alone; four of 140 x 70 on 220 x 220 with one upright beside three.
TEST(Plate, TurnedPartsKeepTheirDistanceToo) {
    struct Try {
        double x, y;
        std::size_t count;
        Vec2 bed;
        plate::QuarterTurns turn;
        std::size_t odd; // how many of them by an odd number of quarters
    };
    const plate::Spacing by{2, 4, true};
    for (const Try& t : {Try{95, 60, 3, {200, 100}, plate::QuarterTurns::all, 3},
                         Try{140, 70, 4, {220, 220}, plate::QuarterTurns::each, 1}}) {
        const std::vector<plate::Thing> bars(t.count, {{{0, 0}, {t.x, 0}, {t.x, t.y}, {0, t.y}}, 10});
        EXPECT_FALSE(plate::pack(bars, by, t.bed).left.empty());
        const plate::Packing packed = plate::pack(bars, by, t.bed, t.turn);
        ASSERT_TRUE(packed.left.empty());
        geom::Box2 box;
        std::size_t odd = 0;
        for (std::size_t i = 0; i < bars.size(); ++i) {
            odd += packed.place[i].quarters % 2 == 1 ? 1 : 0;
            const auto own = moved(bars[i].outline, packed.place[i]);
            for (const Vec2& p : own) box.add(p);
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_TRUE(apart(own, moved(bars[j].outline, packed.place[j]), by.x - 0.005, by.y - 0.005));
        }
        EXPECT_EQ(odd, t.odd);
        EXPECT_LE(box.hi.x - box.lo.x, t.bed.x);
        EXPECT_LE(box.hi.y - box.lo.y, t.bed.y);
    }
}

TEST(Plate, TheHeadSaysHowFarApart) {
    const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const machine::Head head; // carriage 40 x 40, 8 mm above the tip
    const auto of = [&](double a, double b) {
        return plate::spacings(std::vector<plate::Thing>{{square, a}, {square, b}}, head);
    };
    const auto high = of(50, 9);
    ASSERT_EQ(high.size(), 2U);
    EXPECT_TRUE(high[0].clear);
    EXPECT_NEAR(high[0].x, 20, 0.02);
    EXPECT_FALSE(high[1].clear);
    EXPECT_NEAR(high[1].x, head.cone_radius(8), 0.02);
    // the carriage passes over what is lower than the nozzle is long, so the higher part comes later
    const auto low = of(50, 6);
    ASSERT_EQ(low[0].clear, true);
    EXPECT_NEAR(low[0].x, head.cone_radius(6), 0.02);
    machine::Head spans = head;
    spans.gantry_height = 30;
    const auto under = plate::spacings(std::vector<plate::Thing>{{square, 50}, {square, 40}}, spans);
    ASSERT_EQ(under.size(), 1U);
    EXPECT_FALSE(under[0].clear);
    EXPECT_FALSE(plate::spacing(19, std::vector<plate::Thing>{{square, 50}, {square, 40}}, head).clear);
    EXPECT_TRUE(plate::spacing(20, std::vector<plate::Thing>{{square, 50}, {square, 40}}, head).clear);
}

} // namespace
