// Nested loops become one double spiral.
#include "surfpath/rows/double_spirals.hpp"

#include "surface/curve/locate.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::surfpath::double_spirals {

using namespace rows;

namespace {

constexpr double kRadius = 2.4;

Surface sheet() {
    Notes notes;
    return surface::connect(surface::flat_grid(60, 60, 60, 60), notes);
}

// A closed line around the middle of the sheet, clockwise, so that a smaller one is on its right.
Line ring(const Surface& s, double radius, double longer) {
    const surface::curve::Locator locator(s);
    Line out{{}, true};
    const int n = static_cast<int>(20 * radius);
    for (int i = 0; i < n; ++i) {
        const double a = -2 * std::numbers::pi * i / n, side = std::sin(a) >= 0 ? longer : -longer;
        out.places.push_back(locator.nearest({30 + radius * std::cos(a), 30 + radius * std::sin(a) + side, 0}));
    }
    return surface::curve::threaded(s, out);
}

double tight_length(const Surface& s, const Line& line) {
    const auto normals = surface::curve::vertex_normals(s);
    std::vector<Vec3> points, up;
    for (const Place& p : line.places) {
        points.push_back(p.point);
        up.push_back(surface::curve::normal_at(s, normals, p));
    }
    return surface::curve::length(
        surface::curve::tight_turns(points, up, kRadius, surface::curve::turn_reach(kRadius, 1)));
}

// A double spiral over many lines is worth the wedges at its ends; of few lines it is not.
TEST(DoubleSpirals, ManyLoopsBecomeOneWithTwoHalfTurns) {
    const Surface s = sheet();
    for (const double longer : {0.0, 4.0})
        for (int count = 2; count <= 18; ++count) {
            std::vector<Line> lines;
            for (int k = 0; k < count; ++k) lines.push_back(ring(s, 23.0 - k, longer));
            double before = 0;
            for (const Line& line : lines) before += surface::curve::length(line);
            std::vector<Line*> chain;
            for (Line& line : lines) chain.push_back(&line);
            const std::size_t taken = rows::wind_double(s, chain, {.spacing = 1, .gentle = kRadius, .nearest = 0.8});
            SCOPED_TRACE(count);
            if (count <= 5) {
                EXPECT_EQ(taken, 0U);
            }
            // Of circles the outer ones leave larger wedges than exchanges.
            if (count >= 12 && longer > 0) {
                EXPECT_EQ(taken, static_cast<std::size_t>(count - 1));
            }
            if (taken == 0) continue;
            double after = 0;
            for (const Line& line : lines)
                if (line.size() > 0) {
                    EXPECT_TRUE(line.closed);
                    after += surface::curve::length(line);
                }
            EXPECT_NEAR(after, before, 25); // the wedges
            EXPECT_LT(tight_length(s, lines[0]), 8);
        }
}

} // namespace
} // namespace filum::surfpath::double_spirals
