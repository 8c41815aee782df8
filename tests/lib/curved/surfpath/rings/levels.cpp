// Rings of distances with several maxima: each is covered.
#include "surfpath/rings/levels.hpp"

#include "surfpath/rules/rules.hpp"

#include "geodesic/exact.hpp"
#include "geom/disjoint_sets.hpp"
#include "surface/surface.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace filum::surfpath {

using namespace rings;
namespace {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;

// 40 x 30 mm with bumps, a hole, and three rooms with doors, at random.
Surface bumpy(std::mt19937& random) {
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    struct Disc {
        Vec2 at;
        double size, high;
    };
    std::vector<Disc> bumps, holes;
    for (int i = 0; i < 4; ++i) bumps.push_back({{40 * unit(), 30 * unit()}, 4 + 4 * unit(), 6 * unit() - 3});
    holes.push_back({{40 * unit(), 30 * unit()}, 1 + 2 * unit(), 0});
    const double walls[] = {10 + 6 * unit(), 24 + 6 * unit()}, doors[] = {5 + 20 * unit(), 5 + 20 * unit()};
    const double wide = 1.5 + 3 * unit();
    const auto lift = [&](Vec2 p) {
        double z = 0;
        for (const Disc& b : bumps) z += b.high * std::exp(-norm2(p - b.at) / (b.size * b.size));
        return Vec3{p.x, p.y, z};
    };
    const auto hole = [&](Vec2 p) {
        for (std::size_t k = 0; k < 2; ++k)
            if (std::abs(p.x - walls[k]) < 0.6 && std::abs(p.y - doors[k]) > wide / 2) return true;
        return std::any_of(holes.begin(), holes.end(), [&](const Disc& h) { return norm(p - h.at) < h.size; });
    };
    Notes notes;
    return surface::connect(surface::pierced_grid(40, 30, 66, 50, lift, hole), notes);
}

// Vertices from which one must go down by `least` mm to get to a higher one.
std::vector<std::uint32_t> maxima(const Surface& s, const std::vector<double>& distance, double least) {
    std::vector<std::uint32_t> order(distance.size()), top(distance.size()), out;
    std::iota(order.begin(), order.end(), 0U);
    std::iota(top.begin(), top.end(), 0U);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return distance[a] > distance[b]; });
    geom::DisjointSets sets(distance.size());
    std::vector<char> in(distance.size(), 0);
    for (const std::uint32_t v : order) {
        in[v] = 1;
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            for (const std::uint32_t w : s.triangles[h / 3]) {
                std::uint32_t a = top[sets.root(v)], b = top[sets.root(w)];
                if (in[w] == 0 || !sets.unite(v, w)) continue;
                if (distance[a] < distance[b]) std::swap(a, b);
                if (distance[b] - distance[v] >= least) out.push_back(b);
                top[sets.root(v)] = a;
            }
        });
    }
    out.push_back(order[0]);
    return out;
}

double value(const Facts& facts, const std::string& name) {
    for (const Fact& f : facts)
        if (f.name == name) return f.value;
    ADD_FAILURE() << name;
    return -1;
}

TEST(Levels, CoverEveryMaximumOfRandomBumps) {
    std::mt19937 random(9);
    std::size_t several = 0, tops = 0;
    for (int trial = 0; trial < trials(20); ++trial) {
        const Surface s = bumpy(random);
        if (s.components != 1) continue;
        const auto field = geodesic::exact(s, surface::rim_sources(s));
        const double d = 0.3 + 0.01 * (random() % 20);
        Facts facts;
        Notes notes;
        const Levels made = levels(s, field, {d, 0, false}, facts, notes);
        // Five rings are enough to move the innermost by half a spacing; the first two show where the branch begins.
        const auto high = maxima(s, field.distance, 7.5 * d);
        several += high.size() > 1 ? 1 : 0;
        for (const std::uint32_t v : high) {
            double nearest = 1e9;
            for (const auto& line : made.lines)
                for (const Vec3& p : line.points) nearest = std::min(nearest, distance(p, s.vertices[v]));
            // The maximum itself lies up to an edge beside the vertex, and the ring's points lie on edges.
            EXPECT_LT(nearest, d / 2 + 0.1 * d) << trial << ' ' << v << ' ' << d;
            ++tops;
        }
        EXPECT_GE(value(facts, "branches"), static_cast<double>(high.size()));
        EXPECT_LE(value(facts, "spacing-change"), rules::kGive + 1e-9);
        EXPECT_EQ(value(facts, "branches-open") > 0, !notes.empty());
    }
    EXPECT_GE(several, static_cast<std::size_t>(trials(10)));
    EXPECT_GE(tops, static_cast<std::size_t>(trials(40)));
}

// Every line is there once, for any levels of its neighbours.
TEST(Levels, RingsOfNeighbouringBranchesKeepApart) {
    std::mt19937 random(31);
    std::size_t lines = 0;
    for (int trial = 0; trial < trials(6); ++trial) {
        const Surface s = bumpy(random);
        const auto field = geodesic::exact(s, surface::rim_sources(s));
        const double d = 0.4 + 0.01 * (random() % 40);
        Facts facts;
        Notes notes;
        const Levels made = levels(s, field, {d, 0, false}, facts, notes);
        ASSERT_TRUE(std::is_sorted(made.at.begin(), made.at.end()));
        ASSERT_TRUE(std::is_sorted(made.of.begin(), made.of.end()));
        for (std::size_t a = 0; a < made.lines.size(); ++a) {
            ++lines;
            for (std::size_t b = a + 1; b < made.lines.size(); ++b)
                EXPECT_FALSE(made.lines[a].points[0] == made.lines[b].points[0]) << trial;
        }
        // Seen from any vertex, the next ring below is no farther than 1.1 spacings down its way.
        for (std::uint32_t v = 0; v < s.vertices.size(); v += 7) {
            if (field.distance[v] < d) continue;
            double nearest = 1e9;
            for (const auto& line : made.lines)
                for (const Vec3& p : line.points) nearest = std::min(nearest, distance(p, s.vertices[v]));
            EXPECT_LT(nearest, 1.1 * d + 0.05) << trial << ' ' << v;
        }
    }
    EXPECT_GT(lines, 0U);
}

} // namespace
} // namespace filum::surfpath
