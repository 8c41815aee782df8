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
