#include "link3d/strip_route.hpp"

#include "curves.hpp"
#include "geom/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace {

using namespace filum;
using filum::geom::Vec2;

// A narrow loop that is `length` mm long, with its lines 0.8 mm apart.
toolpath::Curve loop(double length) {
    toolpath::Curve c;
    c.closed = true;
    c.points = {{0, 0}, {length, 0}, {length, 0.8}, {0, 0.8}};
    c.width = {0.4};
    return c;
}

std::optional<std::vector<Vec2>> route(const toolpath::Curve& c, Vec2 to) {
    std::vector<std::vector<Vec2>> lines{c.points};
    lines.back().push_back(c.points.front());
    const std::vector<toolpath::Curve> curves{c};
    const link3d::SegmentIndex index(curves);
    return link3d::strip_route(lines, curves, index, c.points[0], 0.4, link3d::kStrips, 1,
                               [&](Vec2 p, int) { return geom::distance(p, to) < 0.5 ? 1 : 0; });
}

TEST(StripRoute, LeadsAlongTheMiddleOfTheStrip) {
    const auto way = route(loop(10), {8, 0.4});
    ASSERT_TRUE(way);
    for (const Vec2 p : *way) EXPECT_LE(std::abs(p.y - 0.4), 0.4);
}

// In the order of the line, 60,000 points in a row would take 10^9 flips, which is minutes.
TEST(StripRoute, ALoopOfTwentyFourMetresTakesNoSquaredTime) {
    auto far = loop(10);
    far.points[1] = {24000, -3000}; // a corner far away, as a forged message has it
    route(far, {8, 0.4});
    EXPECT_TRUE(route(loop(24000), {20000, 0.4}));
}

double between(link3d::test::Random& random, double low, double high) { return low + (high - low) * random(); }

// A narrow loop bent to a C around a void, with rough sides: its strip is about 0.4 mm wide. The void is wider.
toolpath::Curve bent_loop(link3d::test::Random& random) {
    const double radius = between(random, 1.2, 4), opening = between(random, 0.3, 2), rough = between(random, 0, 0.15);
    const int corners = 12 + static_cast<int>(between(random, 0, 40));
    toolpath::Curve c;
    c.closed = true;
    c.width = {0.4};
    for (int i = 0; i < 2 * corners; ++i) {
        const int k = i < corners ? i : 2 * corners - 1 - i;
        const double angle = opening / 2 + (2 * 3.14159265 - opening) * k / (corners - 1);
        const double r = radius + (i < corners ? 0.4 : -0.4) + between(random, -rough, rough);
        c.points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return c;
}

// The segments of a closed curve with at least one end in a box around two points.
std::vector<std::vector<Vec2>> lines_near(const toolpath::Curve& c, Vec2 a, Vec2 b, double margin) {
    geom::Box2 box;
    for (const Vec2 p : {a, b}) {
        box.add(p - Vec2{margin, margin});
        box.add(p + Vec2{margin, margin});
    }
    const auto inside = [&](Vec2 p) {
        return p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y;
    };
    std::vector<std::vector<Vec2>> out;
    for (std::size_t i = 0; i < c.points.size(); ++i) {
        const Vec2 p = c.points[i], q = c.points[(i + 1) % c.points.size()];
        if (inside(p) || inside(q)) out.push_back({p, q});
    }
    return out;
}

// Points of a path that are farther outside the bead than kMostVoid, and segments of the curve that the path crosses.
std::pair<std::size_t, std::size_t> faults(const std::vector<Vec2>& way, const toolpath::Curve& c) {
    std::size_t outside = 0, crossed = 0;
    const double width = c.width[0];
    const std::vector<toolpath::Curve> curves{c};
    const link3d::SegmentIndex index(curves);
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
        const double length = std::max(geom::distance(way[i], way[i + 1]), 1e-9);
        for (double at = 0; at <= length; at += 0.01) {
            const Vec2 p = geom::lerp(way[i], way[i + 1], at / length);
            // a step is examined at least every tenth of the void, and made straight within a twentieth of a width
            if (index.nearest(p)->distance > width * (0.5 + link3d::kMostVoid + 0.1)) ++outside;
        }
        if (!link3d::is_free(index, way[i], way[i + 1], 0, i == 0 ? 1e-6 : 0, 0)) ++crossed;
    }
    return {outside, crossed};
}

TEST(StripRoute, NeverCrossesAVoidWiderThanABead) {
    const char* count = std::getenv("FILUM_TRIES"); // NOLINT(concurrency-mt-unsafe): one thread
    link3d::test::Random random{1};
    int found = 0;
    for (int k = count ? std::atoi(count) : 500; k > 0; --k) { // NOLINT(cert-err34-c): a test's own count
        const auto c = bent_loop(random);
        const auto any = [&] {
            return c.points[static_cast<std::size_t>(between(random, 0, static_cast<double>(c.points.size()) - 0.5))];
        };
        const Vec2 from = any(), to = any();
        const auto lines = lines_near(c, from, to, between(random, 0.4, 4));
        const std::vector<toolpath::Curve> curves{c};
        const link3d::SegmentIndex index(curves);
        const auto way = link3d::strip_route(lines, curves, index, from, 0.4, link3d::kStrips, 1,
                                             [&](Vec2 p, int) { return geom::distance(p, to) < 0.6 ? 1 : 0; });
        if (!way) continue;
        ++found;
        EXPECT_EQ(faults(*way, c), (std::pair<std::size_t, std::size_t>{0, 0})) << k;
    }
    EXPECT_GT(found, 100);
}

} // namespace
