#include "baselines/sun2019/spiral.hpp"

#include "../../fill/pattern_check.hpp"
#include "baselines/sun2019/contour_graph.hpp"

#include <algorithm>

namespace filum::baselines::sun2019 {
namespace {

using namespace test;

TEST(Sun2019, AdjacencyIsTheLeastDistanceOfVertices) {
    for (unsigned seed = 0; seed < 6; ++seed)
        for (const auto& region : random_regions(seed)) {
            const auto rings = contours(region, {});
            const auto edges = adjacency(rings, 0.6);
            std::size_t next = 0;
            for (std::size_t a = 0; a < rings.size(); ++a)
                for (std::size_t b = a + 1; b < rings.size(); ++b) {
                    double least = 1e300;
                    for (const Vec2 p : rings[a])
                        for (const Vec2 q : rings[b]) least = std::min(least, geom::distance(p, q));
                    if (least > 0.6) continue;
                    ASSERT_LT(next, edges.size());
                    EXPECT_EQ(edges[next].a, static_cast<int>(a));
                    EXPECT_EQ(edges[next].b, static_cast<int>(b));
                    EXPECT_EQ(edges[next].distance, least);
                    ++next;
                }
            EXPECT_EQ(next, edges.size());
        }
}

// Pieces of a graph.
std::size_t pieces(std::size_t n, const std::vector<Edge>& edges) {
    std::vector<std::size_t> label(n);
    for (std::size_t i = 0; i < n; ++i) label[i] = i;
    for (bool again = true; again;) {
        again = false;
        for (const auto& e : edges) {
            auto &a = label[static_cast<std::size_t>(e.a)], &b = label[static_cast<std::size_t>(e.b)];
            if (a != b) {
                a = b = std::min(a, b);
                again = true;
            }
        }
    }
    std::sort(label.begin(), label.end());
    return static_cast<std::size_t>(std::unique(label.begin(), label.end()) - label.begin());
}

TEST(Sun2019, ReverseDeleteKeepsWhatHoldsTheGraphTogether) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const std::size_t n = 3 + random() % 8;
        std::vector<Edge> edges;
        for (int a = 0; a < static_cast<int>(n); ++a)
            for (int b = a + 1; b < static_cast<int>(n); ++b)
                if (random() % 3 == 0) edges.push_back({a, b, 1.0, 0, 0});
        std::vector<Edge> expected = edges; // the last one first, unless the graph would fall apart
        for (std::size_t i = expected.size(); i-- > 0;) {
            auto fewer = expected;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
            if (pieces(n, fewer) == pieces(n, edges)) expected = std::move(fewer);
        }
        const auto kept = reverse_delete(n, edges);
        ASSERT_EQ(kept.size(), expected.size());
        for (std::size_t i = 0; i < kept.size(); ++i) {
            EXPECT_EQ(kept[i].a, expected[i].a);
            EXPECT_EQ(kept[i].b, expected[i].b);
        }
        std::size_t roots = 0, children = 0;
        for (const auto& node : tree(n, edges)) {
            roots += node.parent < 0 ? 1 : 0;
            children += node.children.size();
        }
        EXPECT_EQ(roots, pieces(n, edges));
        EXPECT_EQ(children, kept.size());
    }
}

TEST(Sun2019, DiscIsOneSpiralWithoutCrossings) {
    Notes notes;
    const auto region = disc({0, 0}, 6);
    const auto curves = spiral(region, {}, notes);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_FALSE(curves[0].closed);
    EXPECT_EQ(crossings(curves), 0U);
    EXPECT_NEAR(laid(curves) / polygon::signed_area(region), 1, 0.03);
    // both ends outside, one lane apart
    EXPECT_LT(distance_to_outline(region, curves[0].points.front()), 0.25);
    EXPECT_LT(distance_to_outline(region, curves[0].points.back()), 0.65);
}

TEST(Sun2019, StartsOnTheMainAxis) {
    Notes notes;
    const auto along_x = spiral(rectangle(0, 0, 20, 4), {}, notes).at(0).points.front();
    EXPECT_GT(along_x.x, 19);
    EXPECT_NEAR(along_x.y, 2, 0.6);
    const auto along_y = spiral(rectangle(0, 0, 4, 20), {}, notes).at(0).points.front();
    EXPECT_GT(along_y.y, 19);
    const auto shifted = spiral(rectangle(0, 0, 20, 4), {.start_shift = 5}, notes).at(0).points.front();
    EXPECT_GT(geom::distance(along_x, shifted), 3);
}

TEST(Sun2019, EveryContourIsInTheCurves) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const auto& region : random_regions(seed)) {
            Notes notes;
            const auto curves = spiral(region, {}, notes);
            expect_sound(curves);
            double rings = 0, links = 0;
            const auto all = contours(region, {});
            for (const auto& c : all) rings += polygon::perimeter(c);
            for (const auto& c : curves) links += length_of(c);
            // each contour gives up about one offset and gets links of a few
            EXPECT_NEAR(links, rings, 4 * 0.4 * static_cast<double>(all.size()) + 0.4) << seed;
        }
}

TEST(Sun2019, IsRepeatable) {
    Notes notes;
    for (const auto& region : random_regions(9))
        EXPECT_TRUE(same(spiral(region, {}, notes), spiral(region, {}, notes)));
}

TEST(Sun2019, TakesWhateverIsTooSmall) {
    for (const double size : {0.002, 0.05, 0.3, 0.401, 0.41, 0.79}) {
        Notes notes;
        expect_sound(spiral(rectangle(0, 0, size, size), {}, notes));
        expect_sound(spiral(rectangle(0, 0, 10, size), {}, notes));
    }
}

} // namespace
} // namespace filum::baselines::sun2019
