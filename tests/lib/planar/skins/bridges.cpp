#include "../fill/pattern_check.hpp"
#include "polygon/stretches.hpp"
#include "skins/skins.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace filum::skins {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;

// Layer 0 of some outlines, layer 1 of one over them.
std::vector<polygon::Area> bridges_over(const Loops& below, const Loops& deck) {
    std::vector<Region> part;
    for (const auto& [loops, layer] : {std::pair{below, 0U}, {deck, 1U}})
        for (const Loops& piece : polygon::split(loops).part) {
            Region r;
            r.id = static_cast<std::uint32_t>(part.size());
            r.layer = layer;
            r.loops = piece;
            part.push_back(std::move(r));
        }
    Facts facts;
    skins(part, {}, {}, facts);
    std::vector<polygon::Area> out;
    for (const auto& a : part.back().areas)
        if (a.kind == AreaKind::bridge) out.push_back(a);
    return out;
}

Loops turned(Loops loops, double angle) {
    for (auto& p : loops.points)
        p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
    return loops;
}

Loops box(double x0, double y0, double x1, double y1) { return test::loop({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}); }

TEST(Skins, BridgesRunTheShortestWayFromMaterialToMaterial) {
    const Loops deck = box(0, 0, 30, 12);
    struct Case {
        const char* what;
        Loops below;
        double direction; // rad, of the bridge; below 0: none
    };
    const double across = std::numbers::pi / 2;
    const Case cases[] = {
        {"two pillars", polygon::unite(box(0, 0, 5, 12), box(25, 0, 30, 12)), 0},
        {"a cup", polygon::subtract(deck, box(2, 2, 28, 10)), across},
        {"three sides", polygon::subtract(deck, box(2, 2, 30, 10)), across},
        {"a narrow slot", polygon::subtract(deck, box(14, -1, 15.9, 13)), -1},
        {"a wider slot", polygon::subtract(deck, box(14, -1, 16.2, 13)), 0},
        {"one side", box(0, 0, 12, 12), -1},
        {"a middle pillar", box(12, 0, 18, 12), -1},
        {"the same", deck, -1},
    };
    for (const Case& c : cases)
        for (int k = 0; k < 36; k += 7) {
            const double angle = std::numbers::pi * k / 36;
            const auto found = bridges_over(turned(c.below, angle), turned(deck, angle));
            ASSERT_EQ(found.size(), c.direction < 0 ? 0U : 1U) << c.what << " " << k;
            if (found.empty()) continue;
            const double off = std::remainder(found[0].direction - c.direction - angle, std::numbers::pi);
            EXPECT_LT(std::abs(off), 0.04) << c.what << " " << k;
        }
}

// Of any convex hole: no other way is shorter than the one that was found by more than a bead.
TEST(Skins, NoDirectionOfABridgeIsShorter) {
    std::mt19937 random(1);
    const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967296.0); };
    for (int trial = 0; trial < 20; ++trial) {
        const double a = uniform(4, 12), b = uniform(4, 12);
        const Loops hole = polygon::intersect(turned(box(-a, -b, a, b), uniform(0, 3)),
                                              test::disc({uniform(-3, 3), uniform(-3, 3)}, uniform(7, 12)));
        const Loops deck = polygon::offset(hole, 3);
        const auto found = bridges_over(polygon::subtract(deck, hole), deck);
        ASSERT_EQ(found.size(), 1U) << trial;
        const auto widest = [&](double angle) {
            const Loops level = polygon::rotated(found[0].loops, -angle);
            const auto at = polygon::bounds(level);
            double out = 0;
            for (double y = at.lo.y + 0.2; y < at.hi.y; y += 0.4) {
                const auto lines = polygon::scan(level, {y});
                for (const auto& s : lines[0]) out = std::max(out, s.to - s.from);
            }
            return out;
        };
        const double own = widest(found[0].direction);
        for (int k = 0; k < 36; ++k) EXPECT_LE(own, widest(std::numbers::pi * k / 36) + 0.4) << trial;
    }
}

} // namespace
} // namespace filum::skins
