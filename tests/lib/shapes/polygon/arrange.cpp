// Arrangements of random walls: the faces tile the plane, winding is what counting says, outlines are simple.
#include "polygon/arrange.hpp"
#include "../../trials.hpp"
#include "geom/segment.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace filum;
using namespace filum::polygon;

namespace {

double whole(double v, double step) { return std::round(v / step) * step; }

// Loops with corners on a coarse grid, so that they cross, touch, overlap and repeat themselves.
Loops tangle(std::mt19937& random, int loops, int corners, double size, double step) {
    std::uniform_real_distribution<double> at(0, size);
    Loops out;
    for (int l = 0; l < loops; ++l) {
        for (int k = 0; k < corners; ++k) {
            const double x = at(random), y = at(random);
            out.points.push_back({whole(x, step), whole(y, step)});
        }
        out.close();
        if (l % 3 == 0) out.add(std::vector<Vec2>(out[out.size() - 1].begin(), out[out.size() - 1].end()));
    }
    return out;
}

int winding_at(const Loops& loops, Vec2 p) {
    int sum = 0;
    for (const Wall& w : walls(loops)) {
        if ((w.a.y > p.y) == (w.b.y > p.y)) continue;
        const double side = geom::orient(w.a, w.b, p);
        if (w.a.y <= p.y && side > 0) ++sum;
        if (w.b.y <= p.y && side < 0) --sum;
    }
    return sum;
}

bool taken(int w, Fill rule) { return rule == Fill::positive ? w > 0 : rule == Fill::even_odd ? w % 2 != 0 : w != 0; }

double distance_to(const Loops& loops, Vec2 p) {
    double least = 1e300;
    for (const Wall& w : walls(loops)) least = std::min(least, geom::point_segment_distance(w.a, w.b, p));
    return least;
}

// How much of the line at height y is taken.
double taken_length(const Loops& loops, double y, Fill rule) {
    std::vector<std::pair<double, int>> at;
    for (const Wall& w : walls(loops))
        if ((w.a.y > y) != (w.b.y > y))
            at.emplace_back(w.a.x + (w.b.x - w.a.x) * (y - w.a.y) / (w.b.y - w.a.y), w.a.y > y ? 1 : -1);
    std::sort(at.begin(), at.end());
    double sum = 0;
    int winding = 0;
    for (std::size_t k = 0; k + 1 < at.size(); ++k) {
        winding += at[k].second;
        if (taken(winding, rule)) sum += at[k + 1].first - at[k].first;
    }
    return sum;
}

// Simple, except at points where loops touch.
bool crosses_nowhere(const Loops& loops) {
    const auto all = walls(loops);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            const Wall &e = all[i], &f = all[j];
            if (geom::cross_properly(e.a, e.b, f.a, f.b)) return false;
            if ((e.a == f.a && e.b == f.b) || (e.a == f.b && e.b == f.a)) return false;
            for (const Vec2 p : {f.a, f.b})
                if (p != e.a && p != e.b && geom::orient(e.a, e.b, p) == 0 && geom::dot(p - e.a, p - e.b) < 0)
                    return false;
        }
    return true;
}

} // namespace

TEST(Arrange, UnionsHoldWhatWindingSays) {
    std::mt19937 random(7);
    for (int round = 0; round < trials(300); ++round) {
        const double step = round % 3 == 0 ? 1 : round % 3 == 1 ? 0.01 : 1e-4; // 1: everything lies on everything
        const double size = round % 2 == 0 ? 10 : 0.01 + step * 8;             // small: as coarse as the grid
        const Loops in = tangle(random, 1 + round % 5, 3 + round % 7, size, step);
        for (const Fill rule : {Fill::nonzero, Fill::even_odd, Fill::positive}) {
            const Loops out = unite_exactly(in, rule);
            ASSERT_TRUE(crosses_nowhere(out)) << round;
            std::uniform_real_distribution<double> at(0, size);
            for (int k = 0; k < 40; ++k) {
                const double x = at(random), y = at(random);
                if (distance_to(in, {x, y}) < 5e-4) continue; // rounding may move a wall there
                ASSERT_EQ(contains(out, {x, y}), taken(winding_at(in, {x, y}), rule)) << round;
            }
        }
    }
}

TEST(Arrange, AreaIsThatOfRows) {
    std::mt19937 random(8);
    for (int round = 0; round < trials(30); ++round) {
        const Loops in = tangle(random, 6, 9, 20, round % 2 == 0 ? 1e-4 : 0.5);
        for (const Fill rule : {Fill::nonzero, Fill::even_odd, Fill::positive}) {
            double area = 0;
            constexpr double kRow = 0.0063;
            for (double y = kRow / 2; y < 20; y += kRow) area += kRow * taken_length(in, y, rule);
            EXPECT_NEAR(signed_area(unite_exactly(in, rule)), area, 0.05) << round;
        }
    }
}

TEST(Arrange, AUnionOnceMoreIsTheSame) {
    std::mt19937 random(9);
    for (int round = 0; round < 100; ++round) {
        const Loops once = unite_exactly(tangle(random, 4, 8, 5, round % 2 == 0 ? 1e-4 : 0.25));
        const Loops again = unite_exactly(once);
        ASSERT_EQ(once.points, again.points);
        ASSERT_EQ(once.start, again.start);
    }
}

TEST(Arrange, LoopsThatTouchStayApartInLoopsOfTheirOwn) {
    Loops in; // two squares corner to corner; a square hole with a corner on the outline
    in.add(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    in.add(std::vector<Vec2>{{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    in.add(std::vector<Vec2>{{10, 0}, {14, 0}, {14, 4}, {10, 4}});
    in.add(std::vector<Vec2>{{12, 0}, {11, 1}, {12, 2}, {13, 1}});
    const Loops out = unite_exactly(in, Fill::positive);
    ASSERT_EQ(out.size(), 4U);
    int holes = 0;
    for (std::size_t l = 0; l < out.size(); ++l) holes += signed_area(out[l]) < 0 ? 1 : 0;
    EXPECT_EQ(holes, 1);
    EXPECT_NEAR(signed_area(out), 1 + 1 + 16 - 2, 1e-12);
}

TEST(Arrange, WhatHangsLoosePartsNothing) {
    std::vector<Wall> in = {{{0, 0}, {4, 0}},    {{4, 0}, {4, 4}},    {{4, 4}, {0, 4}},   {{0, 4}, {0, 0}},
                            {{1, 1}, {2, 2}, 0}, {{4, 2}, {7, 2}, 0}, {{0, 1}, {4, 3}, 0}};
    const auto plane = arrange(in);
    ASSERT_TRUE(plane);
    EXPECT_EQ(plane->winding.size(), 3U); // outside, and two halves
    EXPECT_NEAR(signed_area(outline(*plane, [](std::uint32_t f) { return f > 0; })), 16, 1e-12);
    EXPECT_EQ(plane->winding[0], 0);
    EXPECT_EQ(plane->winding[1], 1);
    EXPECT_EQ(plane->winding[2], 1);
}

TEST(Arrange, FarAwayAndHuge) {
    for (const double scale : {1.0, 1e3, 1e7}) {
        Loops in;
        const auto square = [&](double x, double y) {
            in.add(
                std::vector<Vec2>{{x, y}, {x + scale, y + 0.1 * scale}, {x + 0.9 * scale, y + scale}, {x, y + scale}});
        };
        square(3 * scale, -5 * scale);
        square(3.5 * scale, -4.7 * scale);
        const Loops out = unite_exactly(in);
        EXPECT_EQ(out.size(), 1U);
        EXPECT_NEAR(signed_area(out) / (scale * scale), signed_area(unite(in)) / (scale * scale), 1e-3 / scale);
    }
}

// With the square of the copies as work, this would take hours.
TEST(Arrange, ManyCopiesAreOne) {
    Loops in;
    for (int copy = 0; copy < 100000; ++copy) in.add(std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    EXPECT_NEAR(signed_area(unite_exactly(in)), 100, 1e-9);
}
