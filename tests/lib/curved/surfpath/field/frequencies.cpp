// Lines that may be nearer to each other or farther apart begin more rarely.
#include "surfpath/field/frequencies.hpp"
#include "surfpath/field/stripes.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace filum::surfpath::field {
namespace {

// A sector of a ring between two radii, 1 rad wide, with its lines along the radii: `outer` / `inner` times as
// many of them fit outside as inside.
struct Sector {
    Surface surface;
    Cells cells;
    std::vector<Vec3> along;
};

Sector sector(double inner, double outer) {
    Notes notes;
    const double middle = (inner + outer) / 2;
    Sector out;
    const auto side = [](double mm) { return static_cast<std::uint32_t>(std::ceil(mm)) + 1; };
    out.surface = surface::connect(surface::grid(outer - inner, middle, side(outer - inner), side(middle),
                                                 [&](geom::Vec2 p) {
                                                     const double r = inner + p.x, a = p.y / middle;
                                                     return Vec3{r * std::cos(a), r * std::sin(a), 0};
                                                 }),
                                   notes);
    out.cells = surface::directions::cells(out.surface);
    for (const Vec3& p : out.surface.vertices) out.along.push_back(1 / norm(p) * p);
    return out;
}

std::size_t births_of(const Sector& s, double change) {
    return births(s.surface, stripes(s.surface, s.cells, s.along, {.spacing = 1, .change = change})).size();
}

TEST(Frequencies, LinesThatSpreadWithinTheLimitsNeedNoBirth) {
    // from 1 / 1.25 to 1 / 0.75 lines per spacing: the widths differ by a factor of 5 / 3 at most
    for (const double ratio : {1.4, 1.6}) {
        const Sector s = sector(25, 25 * ratio);
        EXPECT_GE(births_of(s, 0), 2U) << ratio; // 25 (ratio - 1) more lines outside, two per birth
        EXPECT_EQ(births_of(s, 0.25), 0U) << ratio;
    }
}

TEST(Frequencies, AreInverseToTheRoomOfLines) {
    const Sector s = sector(30, 39);
    const auto found = frequencies(s.surface, s.cells, s.along, 0.25);
    double low = 1e9, high = 0; // of the product with the radius, which should be the same everywhere
    for (std::size_t v = 0; v < found.size(); ++v) {
        low = std::min(low, found[v] * norm(s.surface.vertices[v]));
        high = std::max(high, found[v] * norm(s.surface.vertices[v]));
    }
    EXPECT_LT(high / low, 1.05); // they would differ by 1.3 with one frequency
}

TEST(Frequencies, KeepTheirLimits) {
    const Sector s = sector(10, 60);
    for (const double change : {0.0, 0.1, 0.2, 0.5}) {
        const auto found = frequencies(s.surface, s.cells, s.along, change);
        const auto [least, most] = std::minmax_element(found.begin(), found.end());
        EXPECT_GE(*least, 1 / (1 + change) - 1e-9);
        EXPECT_LE(*most, 1 / (1 - change) + 1e-9);
        if (change == 0) {
            EXPECT_EQ(*least, *most);
        }
    }
}

} // namespace
} // namespace filum::surfpath::field
