#include "regions/regions.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"
#include "regions/outlines.hpp"
#include "regions/overlaps.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::regions {
namespace {

// Every pair of edges, the plain way: the test's own notion of crossing.
template <class Bad>
bool any_pair(const Loops& loops, Bad&& bad) {
    std::vector<std::array<Vec2, 2>> edges;
    for (std::size_t l = 0; l < loops.size(); ++l)
        for (std::size_t i = 0; i < loops[l].size(); ++i)
            edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()]});
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (bad(edges[i], edges[j])) return true;
    return false;
}

bool crosses(const Loops& loops) {
    const auto whole = [](Vec2 p) { return Vec2{std::round(p.x * 1e4), std::round(p.y * 1e4)}; };
    return any_pair(loops, [&](const auto& a, const auto& b) {
        return geom::cross_properly(whole(a[0]), whole(a[1]), whole(b[0]), whole(b[1]));
    });
}

using polygon::nesting;

TEST(Nesting, NamesTheSurroundingLoop) {
    Loops loops;
    add_box(loops, 3, 3, 1, 1);       // an island in the hole
    add_box(loops, 0, 0, 10, 10);     // the outer loop
    add_box(loops, 2, 2, 5, 5, true); // its hole
    add_box(loops, 20, 0, 1, 1);      // apart
    add_box(loops, 8, 8, 1, 1, true); // a second hole
    const auto parent = nesting(loops);
    ASSERT_TRUE(parent);
    EXPECT_EQ(*parent, (std::vector<int>{2, -1, 1, -1, 1}));
}

TEST(Nesting, RefusesWhateverTouches) {
    const auto two = [](std::vector<Vec2> a, std::vector<Vec2> b) {
        Loops l;
        l.add(a);
        if (!b.empty()) l.add(b);
        return nesting(l).has_value();
    };
    const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_TRUE(two(square, {}));
    EXPECT_TRUE(two({{0, 0}, {1, 0}, {2, 0}, {2, 2}}, {}));          // a point on a straight line is no harm
    EXPECT_FALSE(two({{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}));         // a bow tie
    EXPECT_FALSE(two({{0, 0}, {2, 0}, {1, 0}, {1, 2}}, {}));         // a spike
    EXPECT_FALSE(two({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, {})); // a vertex on an edge of its own
    EXPECT_FALSE(two(square, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}));     // corner to corner
    EXPECT_FALSE(two(square, {{2, 0.5}, {4, 0.5}, {4, 1}, {2, 1}})); // side by side
    EXPECT_FALSE(two(square, {{1, 1}, {4, 1}, {4, 3}, {1, 3}}));     // overlapping
    EXPECT_FALSE(two(square, {{1, 0}, {1.5, -1}, {2, -1}}));         // a vertex on an edge
    EXPECT_TRUE(two(square, {{1, -0.0001}, {1.5, -1}, {2, -1}}));    // one grid step off it
}

TEST(Nesting, AgreesWithEveryPairOfEdges) {
    Random random(1);
    int simple = 0;
    for (int trial = 0; trial < 400; ++trial) {
        Loops loops;
        for (int i = 0; i < 3; ++i) loops.add(random_star(random, 6, 0.5, 3, 7));
        const bool touching = any_pair(loops, [](const auto& a, const auto& b) {
            if (a[0] == b[1] || a[1] == b[0]) return false;
            return geom::segment_distance(a[0], a[1], b[0], b[1]) == 0;
        });
        bool nested = false; // solid within solid, which is not simple either
        for (std::size_t i = 0; i < loops.size() && !touching; ++i)
            for (std::size_t j = 0; j < loops.size(); ++j) {
                Loops around;
                around.add(loops[j]);
                nested = nested || (i != j && polygon::contains(around, loops[i][0]));
            }
        EXPECT_EQ(nesting(loops).has_value(), !touching && !nested) << trial;
        simple += touching ? 0 : 1;
    }
    EXPECT_GT(simple, 40);
    EXPECT_LT(simple, 360);
}

TEST(Outlines, NeverCrossWhateverComesIn) {
    Random random(2);
    for (int trial = 0; trial < 150; ++trial) {
        Loops soup;
        for (int i = 0; i < 4; ++i) soup.add(random_star(random, 4, 0.01, 3, 9));
        Notes notes;
        const auto parts = outlines(soup, 0.001, 0, notes);
        double area = 0;
        Loops all;
        for (const auto& part : parts.part) {
            EXPECT_GT(polygon::signed_area(part[0]), 0);
            for (std::size_t l = 1; l < part.size(); ++l) EXPECT_LT(polygon::signed_area(part[l]), 0);
            for (std::size_t l = 0; l < part.size(); ++l) all.add(part[l]);
            area += polygon::signed_area(part);
        }
        EXPECT_FALSE(crosses(all)) << trial;
        EXPECT_NEAR(area, polygon::signed_area(polygon::unite(soup)), 0.1) << trial;
    }
}

TEST(Outlines, StayWithinTheTolerance) {
    Loops circle;
    std::vector<Vec2> points;
    for (int i = 0; i < 20000; ++i) {
        const double a = 2 * std::numbers::pi * i / 20000;
        points.push_back({10 * std::cos(a), 10 * std::sin(a)});
    }
    circle.add(points);
    Notes notes;
    const auto parts = outlines(circle, 0.001, 0, notes);
    ASSERT_EQ(parts.part.size(), 1U);
    const auto loop = parts.part[0][0];
    EXPECT_LT(loop.size(), 600U);
    for (const Vec2 p : points) {
        double nearest = 1;
        for (std::size_t i = 0; i < loop.size(); ++i)
            nearest = std::min(nearest, geom::point_segment_distance(loop[i], loop[(i + 1) % loop.size()], p));
        ASSERT_LT(nearest, 0.0011 + 0.0001);
    }
}

TEST(Outlines, SimplifyingThatMakesThemMeetUnitesThem) {
    Loops loops; // the dent's tip comes within a fraction of a um of the other square
    loops.add(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {2, 4.0004}, {0, 4}});
    add_box(loops, 0, 4.0002, 4, 4);
    Notes notes;
    const auto parts = outlines(loops, 0.001, 0, notes);
    Loops all;
    for (const auto& p : parts.part)
        for (std::size_t l = 0; l < p.size(); ++l) all.add(p[l]);
    EXPECT_FALSE(crosses(all));
    EXPECT_NEAR(polygon::signed_area(all), 32, 0.01);
}

TEST(Inradius, IsATrueLowerBoundWithinTwo) {
    EXPECT_GE(inradius_bound(box(0, 0, 10, 10), 0.2, 0.005), 0.2);
    for (const double w : {0.3, 0.1, 0.03}) {
        const double r = inradius_bound(box(0, 0, 5, w), 0.2, 0.005);
        EXPECT_LE(r, w / 2);
        EXPECT_GE(r, w / 4 - 0.002);
    }
    EXPECT_EQ(inradius_bound(box(0, 0, 5, 0.006), 0.2, 0.005), 0);
    Loops ring = box(0, 0, 10, 10); // many holes: no wall wider than 1
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) add_box(ring, 1 + 3 * i, 1 + 3 * j, 2, 2, true);
    const double r = inradius_bound(ring, 5, 0.005);
    EXPECT_LE(r, std::sqrt(2.0) - 0.0 + 1e-9); // where two walls meet: between the corners of four holes, or less
    EXPECT_GE(r, 0.3);
}

TEST(Overlaps, AgreeWithOneIntersectionPerPair) {
    constexpr double kWide = 0.04;
    Random random(3);
    std::size_t found = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<Loops> sides[2];
        for (auto& s : sides) {
            Loops soup;
            for (int i = 0; i < 8; ++i) soup.add(random_star(random, 12, 0.5, 3, 8));
            s = polygon::split(soup).part;
        }
        const auto lower = layer_of(sides[0], 100);
        auto upper = layer_of(sides[1], 200);
        const auto covered = overlap(upper, lower, 0.4, kWide);
        for (std::size_t k = 0; k < upper.size(); ++k) {
            const auto& u = upper[k];
            double sum = 0;
            for (const auto& l : lower) {
                const double area = polygon::signed_area(polygon::intersect(u.loops, l.loops));
                sum += area;
                const auto it =
                    std::find_if(u.below.begin(), u.below.end(), [&](const auto& o) { return o.below == l.id; });
                const auto common = polygon::intersect(u.loops, l.loops);
                if (it == u.below.end()) { // no contact: no circle of a hairline fits
                    EXPECT_TRUE(polygon::offset(common, -kWide / 2 - 0.002).empty());
                    continue;
                }
                ++found;
                EXPECT_NEAR(it->area, area, 1e-4);
                EXPECT_GE(it->inradius, kWide / 2);
                EXPECT_FALSE(polygon::offset(common, -it->inradius + 0.001).empty());
                EXPECT_TRUE(it->link || polygon::offset(common, -0.11).empty());
            }
            EXPECT_NEAR(covered[k], sum, 1e-3);
        }
    }
    EXPECT_GT(found, 200U);
}

TEST(Overlaps, LinkThinWallsByTheThinner) {
    const auto lower = layer_of({box(0, 0, 10, 0.15)}, 0);
    const auto linked = [&](const Loops& above) {
        auto upper = layer_of({above}, 1);
        overlap(upper, lower, 0.4, 0.04);
        return !upper[0].below.empty() && upper[0].below[0].link;
    };
    EXPECT_TRUE(linked(box(0, 0.01, 10, 0.15)));  // a thin wall that leans a little
    EXPECT_FALSE(linked(box(0, 0.14, 10, 0.15))); // hardly any common area
    EXPECT_TRUE(linked(box(-5, -5, 20, 20)));     // a wide region upon it
    EXPECT_FALSE(linked(box(0, 0.149, 10, 10)));  // a wide one that only brushes it
}

TEST(Regions, TellParentsAndDropSliversWithANote) {
    Loops l = box(0, 0, 10, 10);
    add_box(l, 2, 2, 6, 6, true);
    add_box(l, 4, 4, 2, 2);
    add_box(l, 20, 0, 5, 0.04); // narrower than a hairline
    add_box(l, 30, 0, 5, 0.05); // wider
    Notes notes;
    Air air;
    auto r = regions(layer(l), {}, notes);
    lay_on(r, {false, {}}, {}, air);
    ASSERT_EQ(r.size(), 3U);
    EXPECT_EQ(r[0].id, 0U);
    EXPECT_EQ(r[0].parent, -1);
    EXPECT_NEAR(r[0].area, 64, 1e-9);
    EXPECT_NEAR(r[1].area, 0.25, 1e-9);
    EXPECT_EQ(r[2].parent, 0);
    EXPECT_EQ(r[2].layer, 7U);
    EXPECT_NEAR(r[2].unsupported, 4, 1e-9);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::sliver_dropped);
    EXPECT_NEAR(notes[0].amount, 0.2, 1e-6);
    EXPECT_EQ(notes[0].layer, 7);
}

TEST(Regions, EmptyLayerHasNone) {
    Notes notes;
    EXPECT_TRUE(regions(layer({}), {}, notes).empty());
    EXPECT_TRUE(notes.empty());
}

} // namespace
} // namespace filum::regions
