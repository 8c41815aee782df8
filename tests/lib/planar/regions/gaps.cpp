#include "regions/gaps.hpp"
#include "regions/regions.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::regions {
namespace {

constexpr double kWidth = 0.04; // a hairline

std::vector<polygon::Region> cut(const Loops& contours, double width = kWidth) {
    Notes notes;
    Options how;
    how.hairline = width;
    return regions(layer(contours), how, notes);
}

template <class Move>
Loops moved(const Loops& from, bool mirrored, Move&& move) {
    Loops out;
    for (std::size_t l = 0; l < from.size(); ++l) {
        std::vector<Vec2> p;
        for (const Vec2 q : from[l]) p.push_back(move(q));
        if (mirrored) std::reverse(p.begin(), p.end());
        out.add(p);
    }
    return out;
}

// Every edge divided at random places.
Loops divided(const Loops& from, Random& random) {
    Loops out;
    for (std::size_t l = 0; l < from.size(); ++l) {
        std::vector<Vec2> p;
        for (std::size_t i = 0, n = from[l].size(); i < n; ++i) {
            const Vec2 a = from[l][i], b = from[l][(i + 1) % n];
            p.push_back(a);
            double t = 0;
            for (int k = static_cast<int>(random() % 4); k-- > 0;)
                p.push_back(geom::lerp(a, b, t = uniform(random, t, 1)));
        }
        std::rotate(p.begin(), p.begin() + static_cast<long>(random() % p.size()), p.end());
        out.add(p);
    }
    return out;
}

std::vector<double> areas(const std::vector<polygon::Region>& r) {
    std::vector<double> out;
    for (const auto& x : r) out.push_back(x.area);
    std::sort(out.begin(), out.end());
    return out;
}

TEST(Gaps, BelowAHairlineTheSidesComeTogether) {
    for (const double gap : {0.0, 0.0001, 0.01, 0.0395, 0.0405, 0.1}) {
        Loops side = box(0, 0, 2, 2), corner = side, cross = side;
        add_box(side, 2 + gap, 0.5, 2, 2);
        add_box(corner, 2 + gap / std::numbers::sqrt2, 2 + gap / std::numbers::sqrt2, 2, 2);
        cross.add(std::vector<Vec2>{{2 + gap, 1}, {4, 0}, {4, 2}}); // a tip before a wall
        for (const Loops& l : {side, corner, cross}) EXPECT_EQ(cut(l).size(), gap < kWidth ? 1U : 2U) << gap;
    }
}

TEST(Gaps, AllThatIsDoneIsTold) {
    Loops l = box(0, 0, 2, 2);
    add_box(l, 2.02, 0, 2, 2);
    Notes notes;
    const auto r = regions(layer(l), {}, notes);
    ASSERT_EQ(r.size(), 1U);
    EXPECT_NEAR(r[0].area, 8.04, 1e-3);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::hairline_gap_closed);
    EXPECT_NEAR(notes[0].amount, 0.04, 1e-3);
    EXPECT_NEAR(notes[0].x, 2.01, 0.02);
}

TEST(Gaps, CornersThatTouchGetANeck) {
    Loops l = box(0, 0, 2, 2);
    add_box(l, 2, 2, 2, 2);
    const auto r = cut(l);
    ASSERT_EQ(r.size(), 1U);
    EXPECT_EQ(polygon::split(polygon::offset(r[0].loops, -0.01)).part.size(), 1U);
}

TEST(Gaps, SlitsCloseAndRoomsAndThinWallsStay) {
    Loops ring = box(0, 0, 10, 10); // open by a slit of 0.03: with it closed it has a hole
    ring.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 5.03}, {1, 5.03},
                   {1, 9}, {9, 9},  {9, 1},   {1, 1},  {1, 5},    {0, 5}};
    ring.start = {0, 12};
    const auto closed = cut(ring);
    ASSERT_EQ(closed.size(), 1U);
    EXPECT_EQ(closed[0].loops.size(), 2U);
    EXPECT_NEAR(closed[0].area, 36, 1e-3);
    Loops thin = box(0, 0, 10, 10); // a room behind a wall thinner than a hairline
    add_box(thin, 0.03, 1, 5, 5, true);
    EXPECT_EQ(cut(thin)[0].loops.points, thin.points);
    Loops notch;
    notch.add(std::vector<Vec2>{{0, 0}, {10, 0}, {10, 5}, {5.05, 5}, {5, 1}, {4.95, 5}, {0, 5}}); // acute, but open
    EXPECT_EQ(cut(notch)[0].loops.points, notch.points);
}

// The same shape moved, mirrored, turned, with other points: the same regions.  Where rounding decides, the gaps are
// within a little of a hairline: then the number lies between what slightly wider and narrower ones give.
TEST(Gaps, DependOnTheShapeAlone) {
    Random random(11);
    int joined = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Loops soup;
        for (int i = 0; i < 10; ++i) {
            const Vec2 at{uniform(random, 0, 5), uniform(random, 0, 5)};
            if (i % 2 == 0)
                soup.add(star(random, at, uniform(random, 0.3, 2), 7));
            else
                add_box(soup, std::round(at.x * 4) / 4, std::round(at.y * 4) / 4, 0.5, 0.25 + 0.01 * (trial % 3));
        }
        const Loops part = polygon::unite(soup);
        const auto as_is = cut(part);
        joined += cut(part, 1e-4).size() > as_is.size() ? 1 : 0;
        const double a = uniform(random, 0, 6);
        const auto same = [&](const Loops& other, const char* what) {
            const auto now = cut(other);
            if (now.size() == as_is.size()) {
                const auto x = areas(as_is), y = areas(now);
                for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 0.02) << what << trial;
                return;
            }
            EXPECT_LE(now.size(), cut(part, kWidth - 0.003).size()) << what << trial;
            EXPECT_GE(now.size(), cut(part, kWidth + 0.003).size()) << what << trial;
        };
        same(divided(part, random), "divided ");
        same(moved(part, true, [](Vec2 p) { return Vec2{-p.x, p.y}; }), "mirrored ");
        same(moved(part, false, [](Vec2 p) { return Vec2{-p.y + 13.37, p.x - 7.123}; }), "turned by 90, shifted ");
        same(moved(part, false,
                   [&](Vec2 p) {
                       return Vec2{std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y};
                   }),
             "turned ");
        same(moved(part, false,
                   [&](Vec2 p) {
                       return p + Vec2{uniform(random, -1e-3, 1e-3), uniform(random, -1e-3, 1e-3)};
                   }),
             "jittered ");
    }
    EXPECT_GT(joined, 20);
}

} // namespace
} // namespace filum::regions
