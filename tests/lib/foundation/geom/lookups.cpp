// Every look-up by place finds what a search through all things finds.
#include "geom/disjoint_sets.hpp"
#include "geom/point_grid.hpp"
#include "geom/point_tree.hpp"
#include "geom/polyline.hpp"
#include "geom/segment_grid.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace filum::geom {
namespace {

struct Places {
    std::mt19937 engine{7};
    // Few enough places for equals.
    double number() { return static_cast<double>(engine() % 41) - 20; }
    Vec2 flat() { return {number(), number()}; }
    Vec3 point() { return {number(), number(), number()}; }
};

TEST(PointTree, FindsTheNearestAndOfEqualsTheFirst) {
    Places r;
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back(r.point());
    const PointTree tree(points);
    for (int i = 0; i < 300; ++i) {
        const Vec3 p = r.point();
        std::uint32_t best = 0;
        for (std::uint32_t k = 1; k < points.size(); ++k)
            if (distance(points[k], p) < distance(points[best], p)) best = k;
        const double least = distance(points[best], p);
        EXPECT_EQ(tree.nearest(p).index, best);
        EXPECT_EQ(tree.nearest(p, least).index, best);
        EXPECT_EQ(tree.nearest(p, least - 0.001).index, ~std::uint32_t{0});
    }
    EXPECT_EQ(PointTree({}).nearest({}).index, ~std::uint32_t{0});
}

template <class V>
void leaves_none_out(const std::vector<V>& points, const std::vector<V>& asked, double size) {
    const PointGrid<V> grid(points, size);
    for (const V& p : asked)
        for (const std::int64_t cells : {1, 3}) {
            std::vector<int> seen(points.size(), 0);
            grid.near(p, cells, [&](std::uint32_t i) { ++seen[i]; });
            for (std::size_t i = 0; i < points.size(); ++i) {
                const bool must = distance(points[i], p) <= static_cast<double>(cells) * size;
                EXPECT_TRUE(seen[i] == 1 || (seen[i] == 0 && !must)) << i << " " << size;
            }
        }
}

TEST(PointGrid, LeavesOutNoneThatIsNear) {
    Places r;
    std::vector<Vec2> flat{{1e300, 0}, {-1e300, 3}};
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i) {
        flat.push_back(r.flat());
        points.push_back(r.point());
    }
    for (const double size : {0.0, 0.3, 2.5, 1e6}) {
        leaves_none_out(flat, flat, size);
        leaves_none_out(points, points, size);
    }
    PointGrid<Vec3>().near({}, 1, [](std::uint32_t) { FAIL(); });
}

TEST(SegmentGrid, ACellHasWhatComesNearerThanTheMargin) {
    Places r;
    std::vector<Segment> segments;
    for (int i = 0; i < 60; ++i) segments.push_back({r.flat(), r.flat()});
    segments.push_back({{-20, 3}, {20, 3}});
    for (const double margin : {0.0, 0.7}) {
        const SegmentGrid grid(segments, 1.5, margin);
        std::size_t all = 0;
        for (std::size_t c = 0; c < grid.cells(); ++c) {
            all += grid.in(c).size();
            EXPECT_TRUE(std::is_sorted(grid.in(c).begin(), grid.in(c).end()));
        }
        EXPECT_LT(all, grid.cells() * segments.size() / 2);
        for (std::uint32_t i = 0; i < segments.size(); ++i)
            for (int k = 0; k <= 200; ++k) {
                const Vec2 on = lerp(segments[i].a, segments[i].b, k / 200.0);
                for (const Vec2 off : {Vec2{}, Vec2{0.99 * margin, 0}, Vec2{0, -0.99 * margin}}) {
                    const auto in = grid.in(grid.cell_at(on + off));
                    EXPECT_TRUE(std::binary_search(in.begin(), in.end(), i));
                }
            }
    }
}

TEST(DisjointSets, AreThoseOfPaintingOver) {
    std::mt19937 random(3);
    DisjointSets sets(50);
    std::vector<std::uint32_t> colour(50);
    std::iota(colour.begin(), colour.end(), 0U);
    for (int i = 0; i < 60; ++i) {
        const std::uint32_t a = random() % 50, b = random() % 50, from = colour[a], to = colour[b];
        EXPECT_EQ(sets.unite(a, b), from != to);
        std::replace(colour.begin(), colour.end(), from, to);
    }
    std::vector<std::uint32_t> set;
    const std::size_t count = sets.number(set);
    EXPECT_EQ(count, std::set<std::uint32_t>(colour.begin(), colour.end()).size());
    for (std::size_t v = 0; v < 50; ++v)
        for (std::size_t w = 0; w < 50; ++w) EXPECT_EQ(set[v] == set[w], colour[v] == colour[w]);
}

TEST(Polyline, Lengths) {
    const std::vector<Vec2> flat{{0, 0}, {3, 4}, {3, 4}, {3, 5}};
    EXPECT_EQ(length(flat), 6);
    EXPECT_EQ(arc_lengths(flat), (std::vector<double>{0, 5, 5, 6}));
    EXPECT_EQ(length(std::vector<Vec3>{{0, 0, 7}}), 0);
    EXPECT_TRUE(arc_lengths(std::vector<Vec3>{}).empty());
}

} // namespace
} // namespace filum::geom
