#include "base/error.hpp"
#include "metrics/planar/air.hpp"
#include "metrics/planar/layers.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace filum;
using namespace filum::metrics::planar;

toolpath::Span bead(std::uint32_t layer, geom::Vec2 a, geom::Vec2 b, double width = 0.4) {
    toolpath::Span s;
    s.layer = layer;
    const double z = 0.2 * (layer + 1);
    s.points = {{a.x, a.y, z}, {b.x, b.y, z}};
    s.width = {width};
    s.height = {0.2};
    return s;
}

std::string refusal(const Beads& beads, double pixel) {
    try {
        check_pixel(beads, {}, pixel);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        return e.what();
    }
    return "";
}

TEST(Pixel, RowsTooCloseAreRefusedWithTheLeastDistanceThatIsTaken) {
    for (const double length : {10.0, 300.0, 1e4}) {
        Beads beads;
        for (std::uint32_t layer = 0; layer < 50; ++layer)
            for (int k = 0; k < 40; ++k) add(beads, bead(layer, {0.4 * k, 0}, {0.4 * k, length}));
        EXPECT_EQ(refusal(beads, 0), "");
        EXPECT_EQ(refusal(beads, 0.1), "") << length;
        const std::string text = refusal(beads, 1e-6);
        ASSERT_NE(text, "");
        EXPECT_EQ(refusal(beads, std::stod(text.substr(text.find("at least ") + 9))), "") << text;
    }
}

TEST(Pixel, BeadsThatAreFarTooLongOrThinAreMeasuredAnyway) {
    for (const double length : {1e3, 1e8})
        for (const double width : {0.4, 1e-9}) {
            Beads beads;
            add(beads, bead(0, {0, 0}, {3, 0}));
            add(beads, bead(1, {0, 0}, {0, length}, width));
            EXPECT_EQ(measure_layers(beads, {}, 0, 1).size(), 2U);
            EXPECT_NEAR(measure_air(beads, 0, 1).length, length, 1e-3 * length);
        }
}

} // namespace
