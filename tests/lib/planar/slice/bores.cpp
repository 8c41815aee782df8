#include "slice/bores.hpp"

#include "polygon/clip.hpp"
#include "slice/compensate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace filum;
using polygon::Loops;

Loops disc(geom::Vec2 at, double radius) {
    Loops out;
    constexpr int n = 180;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n;
        out.points.push_back({at.x + radius * std::cos(a), at.y + radius * std::sin(a)});
    }
    out.close();
    return polygon::unite(out);
}

// A bar `width` wide from the middle outwards.
Loops bar(double angle, double from, double to, double width) {
    const geom::Vec2 along{std::cos(angle), std::sin(angle)}, aside = width / 2 * geom::left_of(along);
    Loops out;
    out.add(
        std::vector<geom::Vec2>{from * along - aside, to * along - aside, to * along + aside, from * along + aside});
    return out;
}

struct Compensated {
    std::vector<Loops> layers;
    Notes notes;
};

Compensated compensated(const std::vector<Loops>& stack, double by) {
    Compensated out;
    const auto bores = slice::open_bores(stack, out.notes);
    for (std::size_t i = 0; i < stack.size(); ++i)
        out.layers.push_back(slice::compensated(stack[i], bores[i], {0, 0, by}, 1, out.notes));
    return out;
}

// The windows' jambs may move by this in the bore's wall, mm.
void expect_same(const Loops& a, const Loops& b, double area) {
    EXPECT_LT(polygon::signed_area(polygon::subtract(a, b)) + polygon::signed_area(polygon::subtract(b, a)), area);
}

TEST(OpenBores, AreFollowedThroughWindows) {
    std::mt19937 random(5);
    const auto uniform = [&](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
    };
    for (int k = 0; k < 40; ++k) {
        SCOPED_TRACE(k);
        const double r = uniform(3, 20), wall = uniform(1, 5), by = k % 4 == 3 ? -0.2 : uniform(0.05, 0.4);
        Loops bore = disc({}, r);
        if (k % 3 == 1) bore = polygon::unite(bore, bar(uniform(0, 6), 0, r + wall / 2, r / 3)); // a keyhole
        const Loops closed = polygon::subtract(disc({}, r + wall), bore);
        Loops windowed = closed;
        for (int n = 1 + k % 4; n > 0; --n)
            windowed = polygon::subtract(windowed, bar(uniform(0, 6), r / 2, r + 2 * wall, uniform(0.3, 1) * r));
        const std::vector<Loops> stack{closed, windowed, windowed, closed, windowed, windowed};
        const Compensated done = compensated(stack, by);
        EXPECT_TRUE(done.notes.empty());
        const Loops wider = polygon::offset(bore, by);
        for (const std::size_t i : {1U, 2U, 4U, 5U}) {
            if (by > 0)
                expect_same(done.layers[i], polygon::subtract(windowed, wider), 0.02);
            else // between its windows the wall has come in as on the other layers; beside them up to as far again
                EXPECT_LT(polygon::signed_area(
                              polygon::subtract(done.layers[i], polygon::subtract(disc({}, r + wall), wider))),
                          0.02);
        }
    }
}

// A disc of `n` corners, the first one at `turn`, and a point on each side where a triangle of the wall ends.
Loops coarse_disc(geom::Vec2 at, double radius, int n, double turn, double share) {
    Loops out;
    const auto corner = [&](int k) {
        const double a = turn + 2 * std::numbers::pi * k / n;
        return geom::Vec2{at.x + radius * std::cos(a), at.y + radius * std::sin(a)};
    };
    for (int k = 0; k < n; ++k) {
        out.points.push_back(corner(k));
        if (share > 0) out.points.push_back(geom::lerp(corner(k), corner(k + 1), share));
    }
    out.close();
    return out;
}

// The area with a hole, its points as they are.
Loops with_hole(Loops area, const Loops& hole) {
    area.points.insert(area.points.end(), hole.points.rbegin(), hole.points.rend());
    area.close();
    return area;
}

// Bores that taper, slant, have a step or other corners on each layer, in rings with windows. On every layer with a
// window the wall moves as far as on the others, or a note names the layer.
TEST(OpenBores, TaperSlantAndStepThroughWindows) {
    std::mt19937 random(7);
    const auto uniform = [&](double lo, double hi) {
        return lo + (hi - lo) * (static_cast<double>(random()) / 4294967296.0);
    };
    int followed = 0, noted = 0;
    for (int k = 0; k < 120; ++k) {
        const double r = uniform(4, 15), wall = uniform(2, 5), by = uniform(0.1, 0.3);
        const double taper = k % 4 == 0 ? uniform(-0.2, 0.2) : 0, slant = k % 4 == 1 ? uniform(-0.2, 0.2) : 0;
        const double step = k % 4 == 2 ? uniform(0.3, 1.5) : 0;
        const int corners = k % 4 == 3 ? 16 + static_cast<int>(random() % 40) : 180;
        constexpr std::size_t layers = 8;
        const std::size_t from = 2, to = 2 + random() % 4, at_step = 1 + random() % layers; // windows: from to `to`
        const Loops window = bar(uniform(0, 6), r / 2, r + 4 * wall, uniform(0.3, 1) * r);
        std::vector<Loops> stack, bores;
        for (std::size_t i = 0; i < layers; ++i) {
            const double l = static_cast<double>(i);
            const double radius = r + taper * l + (i >= at_step ? step : 0), turn = corners < 180 ? uniform(0, 6) : 0;
            bores.push_back(coarse_disc({slant * l, 0}, radius, corners, turn, corners < 180 ? uniform(0, 0.9) : 0));
            stack.push_back(with_hole(disc({}, r + 2 * wall + 3), bores.back()));
            if (i >= from && i <= to) stack.back() = polygon::subtract(stack.back(), window);
        }
        const Compensated done = compensated(stack, by);
        const double arc = r * (1 - std::cos(std::numbers::pi / corners));
        for (std::size_t i = from; i <= to; ++i) {
            SCOPED_TRACE(std::to_string(k) + " layer " + std::to_string(i));
            const bool said = std::any_of(done.notes.begin(), done.notes.end(),
                                          [&](const Note& n) { return n.layer == static_cast<std::int64_t>(i); });
            const Loops right = polygon::subtract(stack[i], polygon::offset(bores[i], by));
            const double off = polygon::signed_area(polygon::subtract(right, done.layers[i])) +
                               polygon::signed_area(polygon::subtract(done.layers[i], right));
            const bool as_meant = off < 0.1 + 2 * std::numbers::pi * r * 2 * arc;
            EXPECT_TRUE(as_meant || said) << off << " mm2 of " << 2 * std::numbers::pi * r * by;
            followed += as_meant ? 1 : 0;
            noted += said && !as_meant ? 1 : 0;
        }
    }
    EXPECT_GT(followed, 9 * noted);
}

TEST(OpenBores, LeaveOtherWallsAlone) {
    // A hole in a plate over an open slot as wide as the hole, over nothing, and over a wall that crosses below it.
    Loops plate;
    plate.add(std::vector<geom::Vec2>{{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
    const Loops holed = polygon::subtract(plate, disc({}, 5));
    Loops slot;
    slot.add(std::vector<geom::Vec2>{{-5, -30}, {5, -30}, {5, 30}, {-5, 30}});
    for (const Loops& below : {polygon::subtract(plate, slot), bar(0, 12, 18, 3), bar(1, -15, 15, 1), plate}) {
        const Compensated done = compensated({below, below, holed}, 0.2);
        expect_same(done.layers[0], below, 1e-3);
        expect_same(done.layers[1], below, 1e-3);
    }
}

TEST(OpenBores, SayWhichWallsCouldNotBeFollowed) {
    // solid stands in the bore where the window opens it
    const Loops closed = polygon::subtract(disc({}, 12), disc({}, 8));
    const Loops open = polygon::unite(polygon::subtract(closed, bar(0, 4, 20, 5)), bar(3, 3, 9, 1));
    const Compensated done = compensated({closed, open, closed}, 0.2);
    ASSERT_EQ(done.notes.size(), 1U);
    EXPECT_EQ(done.notes[0].layer, 1);
    EXPECT_NEAR(done.notes[0].amount, 2 * std::numbers::pi * 8 - 6, 1.5);
}

} // namespace
