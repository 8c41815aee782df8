#include "polygon/circles.hpp"

#include <boost/polygon/voronoi.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

namespace filum::polygon {
namespace {

namespace detail = boost::polygon::detail;
using Site = detail::site_event<std::int32_t>;
using Circle = detail::circle_event<double>;
using Exact =
    detail::voronoi_predicates<detail::voronoi_ctype_traits<std::int32_t>>::mp_circle_formation_functor<Site, Circle>;

constexpr int kNear = 1000, kTrials = 20000;

// Segments near a place far from the origin, as Sites has them: any, and such as follow a bend.
class Segments {
  public:
    SiteLine any() { return {point(), point()}; }
    // Line k of a chord polygon of a large circle, ends rounded; `turn`: rad between chords.
    SiteLine bent(int k, double turn = 0.02) {
        const auto at = [&](int i) {
            const double a = turn * i, r = 600 / turn;
            return SitePoint{std::llround(4e5 + r * std::cos(a)), std::llround(5e5 + r * std::sin(a))};
        };
        return {at(k), at(k + 1)};
    }
    SitePoint point() { return {400000 + place_(random_), 500000 + place_(random_)}; }
    int number(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }

  private:
    std::mt19937 random_{5};
    std::uniform_int_distribution<int> place_{-kNear, kNear};
};

Site segment(const SiteLine& l) {
    const auto n = [](std::int64_t v) { return static_cast<std::int32_t>(v); };
    return {n(l.from.x), n(l.from.y), n(l.to.x), n(l.to.y)};
}
Site point(SitePoint p) { return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)}; }

bool is_point(const SiteLine& l) { return l.from.x == l.to.x && l.from.y == l.to.y; }

// Whether both lines run in one direction.
bool same_way(const SiteLine& a, const SiteLine& b) {
    const std::int64_t ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
    return ax * by == ay * bx && ax * bx + ay * by > 0;
}

// Positive if q is left of the line.
std::int64_t side(const SiteLine& l, SitePoint q) {
    return (l.to.x - l.from.x) * (q.y - l.from.y) - (l.to.y - l.from.y) * (q.x - l.from.x);
}

// Numbers that are finite and not near to zero agree.
void expect_same(const SiteCircle& c, const Circle& exact) {
    constexpr double kPlaces = 2 * kCirclePlaces * std::numeric_limits<double>::epsilon(); // Boost's may be off, too
    EXPECT_NEAR(c.x, exact.x(), kPlaces * std::abs(exact.x()));
    EXPECT_NEAR(c.y, exact.y(), kPlaces * std::abs(exact.y()));
    EXPECT_NEAR(c.right, exact.lower_x(), kPlaces * std::abs(exact.lower_x()));
}

// How many of the two circles, asked for by place 1 and 2, our arithmetic gives; they are as Boost has them.
template <class Own, class Boost>
int same_at_both_places(Own&& own, Boost&& boost) {
    int found = 0;
    for (const int place : {1, 2}) {
        const std::optional<SiteCircle> c = own(place == 2);
        if (!c) continue;
        Circle as_boost;
        boost(place, as_boost);
        expect_same(*c, as_boost);
        ++found;
    }
    return found;
}

TEST(Circles, OfThreeLinesAreThoseOfIntegersWithoutLimit) {
    Segments all;
    Exact exact;
    int found = 0, tried = 0;
    for (int k = 0; k < kTrials; ++k) {
        const bool bent = k % 2 == 0;
        const int first = all.number(300);
        const double turn = std::pow(0.5, 5 + all.number(6)); // the slightest is that of rounding
        const SiteLine a = bent ? all.bent(first, turn) : all.any(), b = bent ? all.bent(first + 1, turn) : all.any(),
                       c = bent ? all.bent(first + 2 + all.number(3), turn) : all.any();
        if (is_point(a) || is_point(b) || is_point(c)) continue;
        if (same_way(a, b) || same_way(b, c) || same_way(c, a)) continue; // no circle
        ++tried;
        const auto own = touching_circle(a, b, c);
        if (!own) continue;
        Circle as_boost;
        exact.sss(segment(a), segment(b), segment(c), as_boost);
        expect_same(*own, as_boost);
        ++found;
    }
    EXPECT_GT(tried, kTrials * 9 / 10);
    EXPECT_GT(found, tried * 99 / 100);
}

TEST(Circles, OfAPointAndTwoLinesAreThoseOfIntegersWithoutLimit) {
    Segments all;
    Exact exact;
    int found = 0, tried = 0;
    for (int k = 0; k < 2 * kTrials; ++k) {
        const bool bent = k % 4 == 0;
        const int first = all.number(300);
        const SiteLine a = bent ? all.bent(first) : all.any(), b = bent ? all.bent(first + 2) : all.any();
        const SitePoint p = bent ? all.bent(first + 1).to : k % 4 == 1 ? a.from : all.point(); // or an end of one
        if (is_point(a) || is_point(b)) continue;
        // as Boost hands them over: the first is turned
        const SiteLine one{a.to, a.from};
        if ((side(one, p) > 0) == (side(b, p) > 0) && side(one, p) != 0 && side(b, p) != 0) continue; // no circle
        ++tried;
        found += same_at_both_places(
            [&](bool second) { return touching_circle(p, one, b, second); },
            [&](int place, Circle& out) { exact.pss(point(p), segment(a), segment(b), place, out); });
    }
    EXPECT_GT(tried, kTrials / 2);
    EXPECT_GT(found, 2 * tried * 9 / 10);
}

TEST(Circles, OfTwoPointsAndALineAreThoseOfIntegersWithoutLimit) {
    Segments all;
    Exact exact;
    int found = 0, tried = 0;
    for (int k = 0; k < 2 * kTrials; ++k) {
        const bool bent = k % 4 == 0;
        const int first = all.number(300);
        const SiteLine line = bent ? all.bent(first) : all.any();
        const SitePoint p = bent ? all.bent(first + 2).from : all.point(),
                        q = bent ? all.bent(first + 3).to : all.point();
        if (is_point(line) || is_point({p, q}) || side(line, p) == 0 || side(line, q) == 0) continue;
        if ((side(line, p) > 0) != (side(line, q) > 0)) continue; // no circle
        ++tried;
        // Boost takes the points to lie right of the line
        const SiteLine seen = side(line, p) < 0 ? line : SiteLine{line.to, line.from};
        found += same_at_both_places(
            [&](bool second) { return touching_circle(p, q, line, second); },
            [&](int place, Circle& out) { exact.pps(point(p), point(q), segment(seen), place, out); });
    }
    EXPECT_GT(tried, kTrials / 2);
    EXPECT_GT(found, 2 * tried * 9 / 10);
}

// A line and two points as far from it: of the two circles one is left, for any question.
TEST(Circles, OfPointsParallelToTheLineIsOne) {
    const SiteLine line{{100000, 100000}, {102000, 100000}};
    for (const bool left : {false, true})
        for (const std::int64_t side : {-1, 1}) {
            const auto c = touching_circle(SitePoint{100600, 100000 + 200 * side},
                                           SitePoint{101400, 100000 + 200 * side}, line, left);
            ASSERT_TRUE(c);
            EXPECT_DOUBLE_EQ(c->x, 101000);
            EXPECT_DOUBLE_EQ(c->y, static_cast<double>(100000 + 500 * side));
            EXPECT_DOUBLE_EQ(c->right, 101500);
        }
}

TEST(Circles, OfTheCornerOfTwoLinesIsThatPoint) {
    const auto c =
        touching_circle({1000, 1000}, SiteLine{{0, 0}, {1000, 1000}}, SiteLine{{1000, 1000}, {1000, 0}}, true);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->x, 1000);
    EXPECT_EQ(c->y, 1000);
    EXPECT_EQ(c->right, 1000);
}

TEST(Circles, AreNotToldWhereNumbersDoNotSuffice) {
    const SiteLine a{{0, 1000}, {1000, 1000}}, b{{1000, 1000}, {2000, 1000}};
    EXPECT_FALSE(touching_circle(a, b, {{2000, 1000}, {3000, 1000}})); // parallel
    EXPECT_FALSE(touching_circle({1000, 1000}, a, b, true));           // on both
    EXPECT_FALSE(touching_circle({500, 500}, a, b, true));             // left of both
}

} // namespace
} // namespace filum::polygon
