// Turns of lines side by side become as wide as the least radius, where that costs little.
#include "surfpath/plan/turns.hpp"

#include "../plate_lines.hpp"
#include "surface/curve/turns.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace filum::surfpath::turns {

using namespace plan;

namespace {

using std::numbers::pi;

constexpr double kRadius = 2.4, kNearest = 0.8;

double tight_length(const Surface& s, const std::vector<Line>& lines) {
    const auto normals = surface::curve::vertex_normals(s);
    double out = 0;
    for (const Line& line : lines) {
        std::vector<Vec3> points, up;
        for (const Place& p : line.places) {
            points.push_back(p.point);
            up.push_back(surface::curve::normal_at(s, normals, p));
        }
        out += surface::curve::length(
            surface::curve::tight_turns(points, up, kRadius, surface::curve::turn_reach(kRadius, 1)));
    }
    return out;
}

double least_distance(const Line& a, const Line& b) {
    double out = 1e9;
    for (const Place& p : a.places)
        for (const Place& q : b.places) out = std::min(out, distance(p.point, q.point));
    return out;
}

// Five lines a spacing apart that turn by an angle, as on a ridge between two families of lines.
std::vector<Line> corners(const Surface& s, bool rolled, double angle) {
    std::vector<Line> out;
    const double apart = 1 / std::cos(angle / 2);
    const Vec2 along{std::cos(angle / 2), std::sin(angle / 2)};
    for (int k = 0; k < 5; ++k) {
        const Vec2 tip{30.3, 14.2 + apart * k};
        out.push_back(line_through(s, rolled, {tip + 12 * Vec2{-along.x, along.y}, tip, tip + 12 * along}));
    }
    return out;
}

TEST(RoundTurns, RidgesOfManyAnglesKeepTheRadius) {
    for (const bool rolled : {false, true})
        for (const double degrees : {40.0, 90.0}) {
            SCOPED_TRACE(degrees);
            const Surface s = plate(rolled);
            auto lines = corners(s, rolled, degrees / 180 * pi);
            ASSERT_GT(tight_length(s, lines), 0);
            round_turns(s, lines, {1, kRadius, kNearest});
            EXPECT_EQ(tight_length(s, lines), 0);
            for (std::size_t i = 0; i + 1 < lines.size(); ++i)
                EXPECT_GT(least_distance(lines[i], lines[i + 1]), kNearest);
        }
}

// The half turn of a pair would leave a large void.
TEST(RoundTurns, HalfTurnsStay) {
    const Surface s = plate(false);
    std::vector<Line> lines{line_through(s, false, half_turn_way())};
    const Line before = lines[0];
    round_turns(s, lines, {1, kRadius, kNearest});
    ASSERT_EQ(lines[0].size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(lines[0][i], before[i]);
}

// A line that stands in the inside of a corner keeps it where it is.
TEST(RoundTurns, LinesInTheWayKeepTurns) {
    const Surface s = plate(false);
    auto lines = corners(s, false, pi / 2);
    lines.resize(1);
    lines.push_back(line_through(s, false, {{30.3, 14.9}, {30.3, 24}}));
    const auto before = lines[0].size();
    round_turns(s, lines, {1, kRadius, kNearest});
    EXPECT_EQ(lines[0].size(), before);
}

} // namespace
} // namespace filum::surfpath::turns
