#include "fill/rows/rectilinear.hpp"

#include "../pattern_check.hpp"
#include "polygon/stretches.hpp"
#include "polygon/strips.hpp"

namespace filum::fill {

using namespace rows;

namespace {

using namespace test;

TEST(Rectilinear, FillsARectangleExactly) {
    for (double height = 1; height < 9; height += 0.61) {
        Notes notes;
        const auto lines = rectilinear(rectangle(2, 3, 22, 3 + height), {}, notes);
        double area = 0; // with the half width that a bead reaches beyond each end
        for (const auto& l : lines) {
            EXPECT_EQ(l.points.size(), 2U);
            EXPECT_FALSE(l.closed);
            EXPECT_NEAR(l.width[0], 0.4, 0.4 * 0.34);
            area += (length_of(l) + 0.4) * l.width[0];
        }
        EXPECT_NEAR(area, 20 * height, 0.002 * 20 * height) << height;
        EXPECT_TRUE(notes.empty());
    }
}

TEST(Rectilinear, LinesAreParallelInsideAndNeverCross) {
    for (unsigned seed = 0; seed < 12; ++seed)
        for (const double angle : {0.0, 0.7, std::numbers::pi / 2})
            for (const auto& region : random_regions(seed)) {
                Notes notes;
                const auto lines = rectilinear(region, {.angle = angle}, notes);
                expect_sound(lines);
                EXPECT_EQ(crossings(lines), 0U);
                EXPECT_EQ(farthest_outside(region, lines), 0);
                for (const auto& l : lines) {
                    const Vec2 d = l.points[1] - l.points[0];
                    EXPECT_NEAR(geom::cross(d, {std::cos(angle), std::sin(angle)}), 0, 1e-9);
                }
            }
}

TEST(Rectilinear, TravelsAreShort) {
    Notes notes;
    const auto lines = rectilinear(rectangle(0, 0, 20, 10), {}, notes);
    for (std::size_t i = 1; i < lines.size(); ++i)
        EXPECT_LT(geom::distance(lines[i - 1].points.back(), lines[i].points.front()), 0.5);
}

TEST(Rectilinear, RingsComeFirst) {
    Notes notes;
    const auto region = rectangle(0, 0, 10, 10);
    const auto lines = rectilinear(region, {.rings = 2}, notes);
    EXPECT_TRUE(lines[0].closed && lines[1].closed);
    EXPECT_FALSE(lines[2].closed);
    EXPECT_GT(coverage(region, lines), 0.985);
    for (std::size_t i = 2; i < lines.size(); ++i)
        for (const Vec2 p : lines[i].points) EXPECT_GT(distance_to_outline(region, p), 0.95);
}

TEST(Rectilinear, CoversHardRegions) {
    for (const auto& [name, region] : hard_regions()) {
        Notes notes;
        EXPECT_GT(coverage(region, rectilinear(region, {}, notes)), 0.85) << name;
    }
}

TEST(Rectilinear, TooThinIsSaid) {
    Notes notes;
    rectilinear(rectangle(0, 0, 10, 0.3), {}, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, 3, 0.01);
}

TEST(Rows, ScanAgreesWithContains) {
    for (unsigned seed = 20; seed < 26; ++seed)
        for (const auto& region : random_regions(seed)) {
            const auto box = polygon::bounds(region);
            std::vector<double> y;
            for (double v = box.lo.y - 0.1; v < box.hi.y + 0.1; v += 0.173) y.push_back(v);
            const auto rows = polygon::scan(region, y);
            for (std::size_t i = 0; i < y.size(); ++i)
                for (double x = box.lo.x - 0.5; x < box.hi.x + 0.5; x += 0.31) {
                    const bool in = std::any_of(rows[i].begin(), rows[i].end(), [&](const polygon::LevelStretch& s) {
                        return s.from <= x && x < s.to;
                    });
                    EXPECT_EQ(in, polygon::contains(region, {x, y[i]}));
                }
        }
}

TEST(Rows, CutsFallOnFlats) {
    // a step at 2.9, three and a half beads of 0.8 up: the strips below it stretch, or shrink, to end there
    const auto stairs = polygon::unite(rectangle(0, 0, 10, 8), rectangle(9, 0, 20, 2.9));
    const auto y = polygon::strip_bounds(stairs, 0.8, 0.2);
    EXPECT_EQ(y.front(), 0);
    EXPECT_EQ(y.back(), 8);
    double nearest = 1;
    for (std::size_t i = 0; i + 1 < y.size(); ++i) {
        EXPECT_GE(y[i + 1] - y[i], 0.8 * 0.79);
        EXPECT_LE(y[i + 1] - y[i], 0.8 * 1.21);
        nearest = std::min(nearest, std::abs(y[i] - 2.9));
    }
    EXPECT_LT(nearest, 0.021);
}

} // namespace
} // namespace filum::fill
