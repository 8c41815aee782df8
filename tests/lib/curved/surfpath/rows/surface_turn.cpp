// Turns at several depths behind the rim, between rows that converge or diverge at random.
#include "surfpath/rows/surface_turn.hpp"

#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::surfpath {

using namespace rows;
namespace {

// A plate of 40 x 30 mm with `n` rows from the lower to the upper rim, `below` mm apart there, `above` mm at the other.
Rows fan(const Surface& s, int n, double below, double above) {
    const surface::curve::Locator locator(s);
    std::vector<UnclippedLine> lines;
    for (int i = 0; i < n; ++i) {
        const double k = i - (n - 1) / 2.0;
        Line line{{locator.nearest({20 + k * below, 0, 0}), locator.nearest({20 + k * above, 30, 0})}, false};
        lines.push_back({surface::curve::threaded(s, line), static_cast<double>(i)});
    }
    return rows::rows(s, lines, {0.5, 0.5, 0.5, 0.1, 0});
}

TEST(Turner, HairpinsOfRowsThatConvergeLieAtEveryDepth) {
    std::mt19937 random(11);
    Notes notes;
    const Surface s = surface::connect(surface::flat_grid(40, 30, 40, 30), notes);
    for (int i = 0; i < 20; ++i) {
        const auto between = [&](double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random); };
        const Rows rows = fan(s, 9, between(0.95, 1.1), between(0.6, 1.4));
        const Transits transits(rows);
        for (const double radius : {0.5, 2.4}) {
            const Turner turner(s, rows, transits, turn_options(1, radius, radius < 1));
            for (const SurfaceTurn& turn : turner.candidates()) {
                if (turn.line.size() < 2) continue; // a way around a hole
                const auto deeper = turner.deeper(turn, 0.25);
                const bool next = turn.from / 2 + 1 == turn.to / 2 && turn.line[0].y < 15;
                if (radius < 1 && next) {
                    EXPECT_EQ(deeper.size(), 8U) << i; // less than two lanes
                }
                if (turn.radius < radius) continue;
                for (const SurfaceTurn& one : deeper) EXPECT_GE(one.radius, radius < 1 ? 0.45 : radius - 1e-6) << i;
            }
        }
    }
}

} // namespace
} // namespace filum::surfpath
