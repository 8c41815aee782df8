#include "toolpath/merge.hpp"

#include "../../crossings.hpp"
#include "../../trials.hpp"
#include "geom/polyline.hpp"
#include "geom/segment.hpp"
#include "lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace filum;
using namespace filum::toolpath;
using lines::Move;

namespace {

double whole_volume(const Span& s) {
    double out = 0;
    for (std::size_t i = 0; i + 1 < s.points.size(); ++i) out += volume(s, i);
    return out;
}

// A circle of `radius` round 0,0 in `n` pieces.
Span circle(double radius, int n) {
    Span s{Role::bead, 0, 0, 0, {}, {0.4}, {0.2}};
    for (int k = 0; k <= n; ++k) {
        const double a = 2 * std::numbers::pi * k / n;
        s.points.push_back({radius * std::cos(a), radius * std::sin(a), 0.2});
    }
    return s;
}

std::size_t crossings(const std::vector<Vec3>& line) {
    std::vector<geom::Segment> all;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) all.push_back({line[i].xy(), line[i + 1].xy()});
    return filum::test::crossing_pairs_of(std::move(all));
}

bool same(const Move& a, const Move& b) {
    return a.to == b.to && a.length == b.length && a.volume == b.volume && a.width == b.width && a.height == b.height &&
           a.sweep == b.sweep && a.centre == b.centre && a.first == b.first;
}

} // namespace

TEST(Merge, KeepsTheLineItsEndsAndItsMaterial) {
    std::mt19937 random(7);
    std::size_t given = 0, left = 0;
    for (int k = 0; k < trials(3000); ++k) {
        const Span s = lines::random_line(random);
        Tolerance t;
        t.path = k % 4 == 0 ? 0.1 : k % 4 == 1 ? 0.02 : k % 4 == 2 ? 0.005 : 0;
        t.arcs = k % 2 == 0;
        t.grid = k % 3 == 0 ? 1e-3 : 0;
        const MergeResult m = merge(s, t);
        ASSERT_FALSE(m.moves.empty());
        ASSERT_EQ(m.moves.back().to, s.points.back()) << k;
        const MergeResult again = merge_again(s, m.steps);
        ASSERT_TRUE(std::equal(again.moves.begin(), again.moves.end(), m.moves.begin(), m.moves.end(), same)) << k;
        ASSERT_EQ(again.off, m.off);
        double laid = 0, length = 0;
        for (const Move& move : m.moves) {
            laid += move.volume;
            length += move.length;
        }
        ASSERT_NEAR(laid, whole_volume(s), 1e-9 * (1 + laid)) << k;
        const double chord = t.arcs ? 1e-5 : 0;
        const auto way = lines::way(s.points.front(), m.moves, 1e-5);
        ASSERT_NEAR(length, geom::length(way), 1e-3 * (1 + length)) << k;
        const double most = t.path + 3 * kLeastMove + chord + 1e-9;
        ASSERT_TRUE(lines::follows(s.points, way, most)) << k << ", " << s.points.size() << " points, " << t.path;
        ASSERT_LE(m.off, t.path) << k;
        ASSERT_TRUE(lines::follows(s.points, way, m.off + 3 * kLeastMove + chord + 1e-9)) << k << " off " << m.off;
        if (t.grid > 0) continue; // rounding tangles lines as wild as these: those stay as they are
        given += s.points.size() - 1;
        left += m.moves.size();
    }
    EXPECT_LT(2 * left, given);
}

TEST(Merge, TheJudgeKnowsAWrongLine) {
    const std::vector<Vec3> a{{0, 0, 0}, {10, 0, 0}}, back{{0, 0, 0}, {6, 0, 0}, {4, 0, 0}, {10, 0, 0}};
    EXPECT_TRUE(lines::follows(a, back, 1.01));
    EXPECT_FALSE(lines::follows(a, back, 0.99));
    const std::vector<Vec3> aside{{0, 0, 0}, {5, 1, 0}, {10, 0, 0}};
    EXPECT_TRUE(lines::follows(a, aside, 1.001));
    EXPECT_FALSE(lines::follows(a, aside, 0.999));
    EXPECT_FALSE(lines::follows({{0, 0, 0}, {9, 0, 0}}, a, 0.9));
}

TEST(Merge, NoMoveIsShorterThanAMicrometre) {
    std::mt19937 random(11);
    for (int k = 0; k < 1000; ++k) {
        const Span s = lines::random_line(random);
        Tolerance t;
        t.path = k % 2 == 0 ? 0 : 0.01;
        const MergeResult m = merge(s, t);
        if (m.moves.size() < 2) continue;
        for (const Move& move : m.moves) ASSERT_GE(move.length, kLeastMove * (1 - 1e-9)) << k;
    }
}

// A circle within d needs chords of the root of 8 d R when their ends are on it; wide beads, as a move that is
// longer than three of them may not use all of it.
TEST(Merge, ACircleTakesAsFewStraightMovesAsItsBandAllows) {
    Tolerance t;
    t.path = 0.01;
    for (const double radius : {1.0, 5.0, 40.0}) {
        Span s = circle(radius, 2000);
        s.width = {4};
        const auto m = merge(s, t);
        const double best = 2 * std::numbers::pi * radius / std::sqrt(8 * t.path * radius);
        EXPECT_LE(static_cast<double>(m.moves.size()), 1.06 * best + 2) << radius;
        EXPECT_GE(static_cast<double>(m.moves.size()), best - 1) << radius;
    }
}

// Beads side by side lie where they should, on average: moves bend where the line does.
TEST(Merge, MovesEndAtPointsOfTheLine) {
    std::mt19937 random(5);
    for (int k = 0; k < trials(200); ++k) {
        const Span s = lines::random_line(random);
        Tolerance t;
        t.path = 0.02;
        for (const Move& move : merge(s, t).moves)
            ASSERT_NE(std::find(s.points.begin(), s.points.end(), move.to), s.points.end()) << k;
    }
}

TEST(Merge, ALongMoveOpensNoWiderGapThanAShortOne) {
    Tolerance t;
    t.path = 0.01;
    const Span s = circle(40, 2000);
    const auto m = merge(s, t);
    const double bead = s.width[0];
    for (const Move& move : m.moves)
        EXPECT_LE(move.length * move.length / (8 * 40), 2.2 * t.path * 3 * bead / move.length);
    EXPECT_LE(m.off, 0.8 * t.path);
}

TEST(Merge, NothingCrossesWhatOthersLay) {
    const Span s = circle(5, 500);
    Tolerance t;
    t.path = 0.01;
    // from inside as near as it gets
    std::vector<geom::Segment> others;
    for (int k = 0; k < 50; ++k) {
        const double a = 2 * std::numbers::pi * (k + 0.5) / 50, r = 4.9985;
        others.push_back({{r * std::cos(a), r * std::sin(a)}, {4 * std::cos(a), 4 * std::sin(a)}});
    }
    const auto count = [&](const MergeResult& m) {
        int out = 0;
        const auto way = lines::way(s.points.front(), m.moves, 1e-5);
        for (std::size_t i = 0; i + 1 < way.size(); ++i)
            for (const auto& o : others) out += geom::cross_properly(way[i].xy(), way[i + 1].xy(), o.a, o.b) ? 1 : 0;
        return out;
    };
    EXPECT_GT(count(merge(s, t)), 0);
    EXPECT_EQ(count(merge(s, t, others)), 0);
    t.arcs = true;
    EXPECT_EQ(count(merge(s, t, others)), 0);
}

TEST(Merge, WhatIsNoFillStaysAsGiven) {
    Span s = circle(5, 100);
    s.role = Role::lift;
    Tolerance t;
    t.path = 0.1;
    EXPECT_EQ(merge(s, t).moves.size(), 100U);
}

TEST(Merge, ACircleIsFewArcs) {
    Tolerance t;
    t.path = 0.01;
    t.arcs = true;
    t.grid = 1e-3;
    const auto m = merge(circle(5, 500), t);
    EXPECT_LE(m.moves.size(), 3U);
    for (const Move& move : m.moves) {
        EXPECT_GT(move.sweep, 0); // counter-clockwise
        EXPECT_NEAR(norm(move.centre), 0, 0.01);
    }
    Span other = circle(5, 500);
    std::reverse(other.points.begin(), other.points.end());
    for (const Move& move : merge(other, t).moves) EXPECT_LT(move.sweep, 0);
}

// A machine that cuts arcs into chords keeps to the tolerance, too, or gets no arc.
TEST(Merge, ChordsOfTheMachineStayWithinTheTolerance) {
    std::size_t arcs = 0, refused = 0;
    for (const double radius : {0.5, 5.0, 30.0})
        for (const double chord : {0.1, 1.0, 5.0}) {
            Tolerance t;
            t.path = 0.02;
            t.arcs = true;
            t.chord = chord;
            const Span s = circle(radius, 600);
            const auto m = merge(s, t);
            std::vector<Vec3> way{s.points.front()};
            for (const Move& move : m.moves) {
                const Vec2 arm = way.back().xy() - move.centre;
                const double pieces =
                    move.sweep == 0
                        ? 1
                        : std::max(1.0, std::floor(std::abs(move.sweep) * norm(arm) / std::max(chord, 0.01)));
                for (double k = 1; k < pieces; ++k) {
                    const double c = std::cos(move.sweep * k / pieces), n = std::sin(move.sweep * k / pieces);
                    const Vec2 at = move.centre + Vec2{c * arm.x - n * arm.y, n * arm.x + c * arm.y};
                    way.push_back({at.x, at.y, 0.2});
                }
                way.push_back(move.to);
                (move.sweep != 0 ? arcs : refused) += 1;
            }
            EXPECT_TRUE(lines::follows(s.points, way, t.path + 1e-4)) << radius << " " << chord;
        }
    EXPECT_GT(arcs, 5);
    EXPECT_GT(refused, 5);
}

TEST(Merge, AStraightLineIsOneMove) {
    Span s{Role::bead, 0, 0, 0, {}, {0.4}, {0.2}};
    for (int k = 0; k <= 1000; ++k) s.points.push_back({0.1 * k, 0.05 * k, 0.2});
    Tolerance t;
    t.path = 0.001;
    EXPECT_EQ(merge(s, t).moves.size(), 1U);
    t.path = 0;
    EXPECT_EQ(merge(s, t).moves.size(), 1000U);
}

// The mean section over any bead's width of the line is within the share of what was given.
TEST(Merge, WidthsStayWithinTheirShare) {
    std::mt19937 random(3);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    for (int k = 0; k < 300; ++k) {
        Span s{Role::bead, 0, 0, 0, {}, {}, {0.2}};
        const double swing = uniform(0, 0.5), wave = uniform(0.05, 2), step = uniform(0.01, 0.3);
        for (int i = 0; i <= 400; ++i) {
            s.points.push_back({step * i, 0, 0.2});
            s.width.push_back(0.4 * (1 + swing * std::sin(wave * step * i)));
        }
        Tolerance t;
        t.path = 0.01;
        const auto m = merge(s, t);
        // mm3 laid as far as x, as given and as moved
        const auto laid = [&](double x) {
            double sum = 0;
            for (std::size_t i = 0; i + 1 < s.points.size() && s.points[i].x < x; ++i) {
                const double f = std::min(1.0, (x - s.points[i].x) / step), w = s.width[i], v = s.width[i + 1];
                sum += step * f * (w + f * (v - w) / 2) * 0.2;
            }
            return sum;
        };
        const auto moved = [&](double x) {
            double sum = 0, at = 0;
            for (const Move& move : m.moves) {
                sum += move.volume * std::clamp((x - at) / (move.to.x - at), 0.0, 1.0);
                at = move.to.x;
            }
            return sum;
        };
        const double bead = 0.4 * (1 + swing);
        for (double x = 0; x + bead < 400 * step; x += 0.37) {
            const double wanted = laid(x + bead) - laid(x), is = moved(x + bead) - moved(x);
            // where a move that is right at each point meets one that is right on average
            ASSERT_NEAR(is, wanted, 1.5 * t.section * wanted + 1e-9) << k << " at " << x;
        }
    }
}

// Two lines nearer to each other than the tolerance; each one could be straightened through the other.
TEST(Merge, NothingCrossesThatDidNot) {
    std::mt19937 random(5);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    int tangled = 0;
    for (int k = 0; k < trials(400); ++k) {
        Span s{Role::bead, 0, 0, 0, {}, {0.4}, {0.2}};
        const double gap = uniform(0.0005, 0.02), wave = uniform(0.2, 3);
        const auto side = [&](double x) { return 0.008 * std::sin(wave * x) + 0.004 * std::sin(3.7 * wave * x + k); };
        for (int i = 0; i <= 100; ++i) s.points.push_back({0.1 * i, side(0.1 * i), 0.2});
        s.points.push_back({11, 0, 0.2});
        for (int i = 100; i >= 0; --i) s.points.push_back({0.1 * i, side(0.1 * i) - gap, 0.2});
        ASSERT_EQ(crossings(s.points), 0U);
        Tolerance t;
        t.path = 0.01;
        t.arcs = k % 2 == 0;
        const auto m = merge(s, t);
        EXPECT_EQ(crossings(lines::way(s.points.front(), m.moves, 1e-7)), 0U) << k;
        tangled += m.moves.size() > 100 ? 1 : 0;
    }
    EXPECT_GT(tangled, 0); // it did happen
}

TEST(Merge, NothingCrossesInWholeMicrometres) {
    // two lines that the program's decimals bring together: moves that were apart by less may cross there
    std::mt19937 random(11);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    const auto rounded = [](std::vector<Vec3> way) { // in micrometres: what touches there does not cross
        for (Vec3& p : way) p = {std::round(p.x * 1000), std::round(p.y * 1000), p.z};
        return way;
    };
    std::size_t before = 0;
    for (int k = 0; k < 400; ++k) {
        Span s{Role::bead, 0, 0, 0, {}, {0.4}, {0.2}};
        const double gap = uniform(0.001, 0.004), tilt = uniform(-0.02, 0.02), bend = uniform(0.02, 0.2);
        const auto side = [&](double x) { return tilt * x + 0.01 * std::sin(bend * x * x); };
        for (int i = 0; i <= 60; ++i) s.points.push_back({0.1 * i, side(0.1 * i), 0.2});
        s.points.push_back({7, 0, 0.2});
        for (int i = 60; i >= 0; --i) s.points.push_back({0.1 * i + 0.05, side(0.1 * i + 0.05) - gap, 0.2});
        if (crossings(s.points) + crossings(rounded(s.points)) > 0) continue; // before anything is merged
        Tolerance t;
        t.path = 0.01;
        const auto loose = merge(s, t);
        before += crossings(rounded(lines::way(s.points.front(), loose.moves, 1e-7)));
        t.grid = 1e-3;
        const auto m = merge(s, t);
        EXPECT_EQ(crossings(rounded(lines::way(s.points.front(), m.moves, 1e-7))), 0U) << k;
    }
    EXPECT_GT(before, 0); // rounding alone did it
}
