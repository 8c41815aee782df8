#include "geom/capsule_tree.hpp"

#include "geom/segment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace filum::geom {
namespace {

using Segments = std::vector<CapsuleTree::Segment>;

// A random walk, rows that go to and fro, or a circle, by `kind`; in a random direction.
Segments curve(std::mt19937& random, int kind, std::size_t n) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const double angle = 4 * unit(random);
    const Vec2 x{std::cos(angle), std::sin(angle)};
    std::vector<Vec2> points{{100 * unit(random), 100 * unit(random)}};
    for (std::size_t i = 0; i < n; ++i) {
        const double a = 6.28 * static_cast<double>(i) / static_cast<double>(n);
        const Vec2 rows = i % 2 == 1 ? 0.5 * left_of(x) : (i % 4 == 0 ? 50.0 : -50.0) * x;
        const Vec2 way = kind == 0   ? Vec2{unit(random), unit(random)}
                         : kind == 1 ? rows
                                     : Vec2{std::cos(a), std::sin(a)};
        points.push_back(points.back() + way);
    }
    Segments out;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) out.emplace_back(points[i], points[i + 1]);
    return out;
}

TEST(CapsuleTree, FindsWhatLooksAtEverySegment) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-150, 150), size(0, 20);
    for (int trial = 0; trial < 300; ++trial) {
        const Segments segments = curve(random, trial % 3, 1 + random() % 200);
        const CapsuleTree tree(segments);
        const Vec2 p{place(random), place(random)};
        double nearest = INFINITY, found = INFINITY;
        for (const auto& [a, b] : segments) nearest = std::min(nearest, point_segment_distance(a, b, p));
        tree.near(p, found, [&](const CapsuleTree::Run& run) {
            for (std::size_t k = run.first; k < run.last; ++k)
                found = std::min(found, point_segment_distance(segments[k].first, segments[k].second, p));
            return found;
        });
        EXPECT_EQ(nearest, found);

        Box2 box;
        box.add(p);
        box.add(p + Vec2{size(random), size(random)});
        std::vector<char> visited(segments.size(), 0);
        std::size_t next = 0;
        tree.visit(box, [&](const CapsuleTree::Run& run) {
            EXPECT_GE(run.first, next);
            next = run.last;
            std::fill(visited.begin() + static_cast<std::ptrdiff_t>(run.first),
                      visited.begin() + static_cast<std::ptrdiff_t>(run.last), 1);
            return true;
        });
        for (std::size_t k = 0; k < segments.size(); ++k) // each point of a segment that lies in the box
            for (int i = 0; i <= 50; ++i)
                if (const Vec2 q = lerp(segments[k].first, segments[k].second, i / 50.0); distance2(box, q) == 0) {
                    EXPECT_EQ(visited[k], 1);
                }
    }
}

TEST(CapsuleTree, CapsulesHoldTheirSegmentsAlsoWhenShifted) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 60; ++trial) {
        const Segments segments = curve(random, trial % 3, 1 + random() % 100);
        CapsuleTree tree(segments);
        const Vec2 way{3, -4};
        tree.shift(way);
        std::size_t node = 0;
        for (; !tree.leaf(node); node = 2 * node + 1) {
        }
        for (std::size_t leaf = node; leaf < 2 * node + 1; ++leaf)
            for (std::size_t k = tree.run(leaf).first; k < tree.run(leaf).last; ++k)
                for (std::size_t i = leaf;; i = (i - 1) / 2) {
                    EXPECT_LE(distance(tree[i], segments[k].first + way), 0);
                    EXPECT_LE(distance(tree[i], segments[k].second + way), 0);
                    if (i == 0) break;
                }
    }
}

TEST(CapsuleTree, IsNarrowAroundRows) {
    std::mt19937 random(3);
    const CapsuleTree tree(curve(random, 1, 15)); // 8 rows of 50 mm, half a millimetre apart
    EXPECT_LT(tree[0].radius, 2.1);
}

TEST(CapsuleTree, MayBeEmpty) {
    const CapsuleTree tree;
    tree.near({0, 0}, INFINITY, [](const CapsuleTree::Run& run) {
        EXPECT_EQ(run.first, run.last);
        return 0.0;
    });
    EXPECT_LT(tree[0].radius, 0);
}

} // namespace
} // namespace filum::geom
