#include "polygon/voronoi.hpp"

#include "../../planar/fill/pattern_check.hpp"

#include <boost/polygon/voronoi.hpp>

#include <numbers>
#include <random>

namespace filum::polygon {
namespace {

using test::Loops;

// Half-widths of gaps between places in the two diagrams that count as the same, grid units of 0.1 um.
constexpr double kSame = 1e-3;

std::vector<Vec2> sorted(std::vector<Vec2> vertices, const Loops& region) {
    const auto box = polygon::bounds(region);
    const double far = 4 * kGridPerMm * std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y);
    // those far off are of no use to anybody
    std::erase_if(vertices, [&](Vec2 p) { return std::abs(p.x) > far || std::abs(p.y) > far; });
    std::sort(vertices.begin(), vertices.end(), [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return vertices;
}

// Each place of `a` lies by one of `b`, which are sorted by x.
void expect_among(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
    for (const Vec2 p : a) {
        auto i = std::lower_bound(b.begin(), b.end(), p.x - kSame, [](Vec2 q, double x) { return q.x < x; });
        bool found = false;
        for (; i != b.end() && i->x <= p.x + kSame && !found; ++i) found = geom::distance(*i, p) < kSame;
        EXPECT_TRUE(found) << p.x << ' ' << p.y;
    }
}

void expect_as_by_boost(const Loops& region) {
    const Sites sites = sites_of(region, 0.001);
    const std::optional<Diagram> found = voronoi(sites);
    ASSERT_TRUE(found.has_value());
    const Diagram& own = *found;
    boost::polygon::voronoi_diagram<double> boosts;
    boost::polygon::default_voronoi_builder builder;
    for (std::size_t i = 0; i < sites.size(); ++i)
        builder.insert_segment(sites.x[i], sites.y[i], sites.x[sites.next[i]], sites.y[sites.next[i]]);
    builder.construct(&boosts);
    std::vector<Vec2> vertices;
    for (const auto& v : boosts.vertices()) vertices.push_back({v.x(), v.y()});
    EXPECT_EQ(own.part.size(), boosts.num_cells());
    const auto a = sorted(own.vertex, region), b = sorted(vertices, region);
    ASSERT_GE(b.size(), sites.size() / 2);
    expect_among(a, b);
    expect_among(b, a);
}

TEST(Voronoi, IsThatOfBoost) {
    for (unsigned seed = 0; seed < 40; ++seed)
        for (const Loops& r : test::random_regions(seed)) expect_as_by_boost(r);
    for (const auto& [name, r] : test::hard_regions()) expect_as_by_boost(r);
}

// Regular polygons, whose segments all touch one circle, and smooth outlines, where neighbours are nearly parallel.
TEST(Voronoi, IsThatOfBoostWhereManySegmentsTouchOneCircleOrAreNearlyParallel) {
    for (const int n : {3, 4, 6, 17, 64, 1000})
        for (const double wave : {0.0, 0.1}) {
            std::vector<Vec2> loop;
            for (int i = 0; i < n; ++i) {
                const double a = 2 * std::numbers::pi * i / n, r = 10 + wave * std::sin(5 * a);
                loop.push_back({r * std::cos(a), r * std::sin(a)});
            }
            expect_as_by_boost(test::loop(loop));
        }
    Loops plate = test::rectangle(0, 0, 31, 31);
    for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 5; ++k) {
            const double x = 1 + 6 * i, y = 1 + 6 * k;
            plate.add(std::vector<Vec2>{{x, y}, {x, y + 5}, {x + 5, y + 5}, {x + 5, y}});
        }
    expect_as_by_boost(plate);
}

TEST(Voronoi, IsThatOfBoostForNoise) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> noise(-0.3, 0.3);
    for (const double along : {0.02, 1.0}) { // coarse teeth, and fine ones on a smooth outline
        std::vector<Vec2> loop;
        const int n = 2000;
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n, r = 20 + along * noise(random);
            loop.push_back({r * std::cos(a), r * std::sin(a)});
        }
        expect_as_by_boost(test::loop(loop));
    }
}

} // namespace
} // namespace filum::polygon
