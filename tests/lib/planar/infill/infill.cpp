#include "infill/infill.hpp"

#include "../../trials.hpp"
#include "../fill/pattern_check.hpp"
#include "geom/segment.hpp"
#include "infill/squares.hpp"
#include "polygon/segments.hpp"
#include "polygon/simple.hpp"
#include "polygon/stretches.hpp"

#include <cmath>

namespace filum::infill {
namespace {

using polygon::InfillPattern;

constexpr double kWidth = 0.4;

std::vector<Loops> random_areas(unsigned seed, double scale) {
    std::vector<Loops> out;
    for (Loops area : test::random_regions(seed)) {
        for (auto& p : area.points) p = scale * p;
        if (polygon::signed_area(area) > 60) out.push_back(std::move(area));
    }
    return out;
}

Lines lines_of(InfillPattern pattern, unsigned seed, double spacing) {
    return {pattern, 0.1 * seed, spacing, kWidth, 0.2 * seed};
}

TEST(Infill, LoopsAreSimpleInsideAndABeadApart) {
    unsigned areas = 0, necks = 0;
    for (const InfillPattern pattern : {InfillPattern::rows, InfillPattern::wave, InfillPattern::concentric})
        for (unsigned seed = 0, n = trials(40); seed < n; ++seed)
            for (const Loops& area : random_areas(seed, 2)) {
                const Loops found = loops(area, lines_of(pattern, seed, 1 + 0.1 * seed));
                EXPECT_TRUE(found.empty() || polygon::is_simple(found)) << seed;
                // half a bead inside, to the rounding of corners
                const Loops room = polygon::offset(area, -kWidth / 2 + 0.02);
                EXPECT_LT(polygon::signed_area(polygon::subtract(found, room)), 1e-4) << seed;
                // nothing narrower than a bead: opening takes nothing but roundings away
                const Loops open = polygon::offset(polygon::offset(found, -kWidth / 2 + 0.02), kWidth / 2 - 0.02);
                const Loops lost = polygon::subtract(found, open);
                if (pattern != InfillPattern::concentric) {
                    EXPECT_LT(polygon::signed_area(lost), 0.01 + 1e-3 * polygon::signed_area(area)) << seed;
                    continue;
                }
                // corners of links are sharp; necks are there where no place for a link has shoulders
                ++areas;
                for (const Loops& piece : polygon::split(lost).part)
                    if (polygon::signed_area(piece) > kWidth * kWidth / 4) ++necks;
            }
    EXPECT_LE(10 * necks, std::max(10U, areas))
        << necks; // 3 of 40 areas now: what a better choice of places would mend
}

// All of an area except what is lower than half a bead, or ends half a bead beyond a row; each square whole.
TEST(Infill, SquaresAreWhole) {
    unsigned areas = 0;
    for (unsigned seed = 0, n = trials(40); seed < n; ++seed)
        for (const Loops& within : random_areas(seed, 2)) {
            const Lines lines = lines_of(InfillPattern::rows, seed, 2 + 0.1 * seed);
            const double s = lines.spacing;
            const Loops area = polygon::intersect(within, test::disc({0.3 * seed, 1}, 5));
            const Loops squares = whole_squares(area, within, lines);
            EXPECT_LT(polygon::signed_area(polygon::subtract(squares, within)), 1e-3) << seed;
            const Loops left = polygon::opened(polygon::subtract(area, squares), kWidth / 2 + 0.01);
            EXPECT_LT(polygon::signed_area(left), 1e-3) << seed;
            const Loops level =
                polygon::rotated(polygon::opened(polygon::subtract(within, squares), 0.01), -lines.direction);
            for (const Loops& part : polygon::split(level).part) { // nothing taken of a square without all of it
                const geom::Vec2 p = geom::lerp(polygon::bounds(part).lo, polygon::bounds(part).hi, 0.5);
                const double x = std::floor(p.x / s) * s, y = std::floor(p.y / s) * s;
                if (!polygon::contains(part, p)) continue;
                Loops square;
                square.add(std::vector<geom::Vec2>{{x, y}, {x + s, y}, {x + s, y + s}, {x, y + s}});
                const Loops taken =
                    polygon::intersect(polygon::rotated(squares, -lines.direction), polygon::offset(square, -0.01));
                EXPECT_LT(polygon::signed_area(taken), 1e-3) << seed;
                ++areas;
            }
        }
    EXPECT_GT(areas, 10U);
}

// Of the tasks' areas, what beads cover that are one spacing apart.
double share_of(const std::vector<Task>& tasks, double spacing) {
    double laid = 0, area = 0;
    for (Task t : tasks) {
        t.lines.spacing = spacing;
        laid += kWidth * length(loops(*t.area, t.lines));
        area += polygon::signed_area(*t.area);
    }
    return laid / area;
}

TEST(Infill, DensityIsWithinTwoPercent) {
    for (const InfillPattern pattern : {InfillPattern::rows, InfillPattern::wave})
        for (const double density : kSanitized ? std::vector{0.3} : std::vector{0.1, 0.15, 0.3, 0.5})
            for (unsigned part = 0, n = trials(4); part < n; ++part) { // parts of 24 layers, with areas that change
                std::vector<Loops> areas;
                for (unsigned layer = 0; layer < 24; ++layer)
                    for (Loops& area : random_areas(7 * part + layer / 8, 3 + 0.01 * layer))
                        areas.push_back(std::move(area));
                std::vector<Task> tasks;
                for (unsigned i = 0; i < areas.size(); ++i)
                    tasks.push_back({&areas[i], {pattern, (i % 2) * 1.5707963267948966, 0, kWidth, 0.2 * i}});
                const double spacing = spacing_for(tasks, density, kWidth);
                EXPECT_NEAR(share_of(tasks, spacing), density, 0.02 * density)
                    << "pattern " << static_cast<int>(pattern) << " part " << part << " spacing " << spacing;
            }
}

// Where lines are few, what follows the walls must not fill more than was asked for.
TEST(Infill, DensityOfFewLinesIsWithinFivePercent) {
    for (const InfillPattern pattern : {InfillPattern::rows, InfillPattern::wave})
        for (const double density : kSanitized ? std::vector{0.05} : std::vector{0.01, 0.03, 0.05}) {
            std::vector<Loops> areas; // a part of 24 layers, about 60 mm wide
            for (unsigned layer = 0; layer < 24; ++layer)
                for (Loops& area : random_areas(layer / 8, 6 + 0.01 * layer)) areas.push_back(std::move(area));
            std::vector<Task> tasks;
            for (unsigned i = 0; i < areas.size(); ++i)
                tasks.push_back({&areas[i], {pattern, (i % 2) * 1.5707963267948966, 0, kWidth, 0.2 * i}});
            const double spacing = spacing_for(tasks, density, kWidth);
            EXPECT_NEAR(share_of(tasks, spacing), density, 0.05 * density)
                << "pattern " << static_cast<int>(pattern) << " spacing " << spacing;
        }
}

TEST(Infill, DensityOfConcentricLinesIsWithinTwoPercent) {
    for (const double density : {0.15, 0.3}) {
        std::vector<Loops> areas;
        for (unsigned layer = 0; layer < 6; ++layer)
            for (Loops& area : random_areas(layer / 2, 2 + 0.02 * layer)) areas.push_back(std::move(area));
        std::vector<Task> tasks;
        for (const Loops& area : areas) tasks.push_back({&area, lines_of(InfillPattern::concentric, 0, 0)});
        const double spacing = spacing_for(tasks, density, kWidth);
        const double share = share_of(tasks, spacing);
        EXPECT_NEAR(share, density, 0.02 * density) << "spacing " << spacing;
        EXPECT_NEAR(share_laid(tasks, spacing, kWidth), share, 1e-9);
    }
}

// With one rim, what is left of an area beside a skin has the lines of the whole area: it lies on them.  Others follow
// the skin, or are links.
TEST(Infill, ConcentricLinesOfOneRimLieOnEachOther) {
    for (unsigned seed = 0, n = trials(12); seed < n; ++seed)
        for (const Loops& rim : random_areas(seed, 3)) {
            Lines lines = lines_of(InfillPattern::concentric, seed, 3);
            lines.rim = &rim;
            const Loops skin = test::disc({2, 1}, 4), area = polygon::opened(polygon::subtract(rim, skin), kWidth);
            const auto below = polygon::segments(loops(rim, lines)), above = polygon::segments(loops(area, lines));
            const Loops room = polygon::offset(area, -kWidth);
            double all = 0, off = 0;
            for (const auto& s : above) {
                const geom::Vec2 p = geom::lerp(s.a, s.b, 0.5);
                if (!polygon::contains(room, p)) continue;
                const bool lies = std::any_of(below.begin(), below.end(), [&](const auto& b) {
                    return geom::point_segment_distance(b.a, b.b, p) < kWidth / 2;
                });
                all += geom::distance(s.a, s.b);
                off += lies ? 0 : geom::distance(s.a, s.b);
            }
            EXPECT_LT(off, 0.15 * all + 12) << seed; // two links of two lines
        }
}

// A ring of a wall around a hole, and one outside, with lines between: along them one comes everywhere.
TEST(Infill, ConcentricLinesJoinAllOutlines) {
    const Loops hole = test::disc({20, 20}, 5), far = test::disc({9, 9}, 3);
    for (const double spacing : {1.5, 2.2, 4.0, 8.0, 13.0, 40.0}) {
        Loops area = test::loop({{0, 0}, {40, 0}, {40, 40}, {0, 40}});
        area = polygon::subtract(polygon::subtract(area, hole), far);
        const Loops &outlines = area, found = loops(area, {InfillPattern::concentric, 0, spacing, kWidth, 0});
        // a bead's reach around what is laid, and around walls: one connected thing
        Loops laid;
        for (const Loops* lines : {&found, &outlines})
            for (std::size_t l = 0; l < lines->size(); ++l) {
                std::vector<geom::Vec2> line((*lines)[l].begin(), (*lines)[l].end());
                line.push_back(line.front());
                laid = polygon::unite(laid, polygon::around(line, 0.55 * kWidth));
            }
        EXPECT_EQ(polygon::split(laid).part.size(), 1U) << spacing;
    }
}

// Every line of rows is passed once: a square of side l has l / spacing of them, and half of its outline.
TEST(Infill, EachLineIsPassedOnce) {
    const Loops square = test::loop({{0, 0}, {60, 0}, {60, 60}, {0, 60}});
    const double laid = length(loops(square, {InfillPattern::rows, 0, 6, kWidth, 0}));
    EXPECT_NEAR(laid, 9 * 59.6 + 119.2, 4); // except for the two in the outline
}

// Lines that carry: those that go on below are among them, no gap is wider than asked for, and the first between them
// are within half of that from one that goes on, as long as three fit.
TEST(Infill, NoGapIsWiderThanAskedFor) {
    for (const double spacing : {2.0, 2.5, 3.4, 4.4, 7.0, 13.0})
        for (const double gap : {0.5, 1.0, 2.0}) {
            const Loops square = test::loop({{0, 0}, {60, 0}, {60, 60}, {0, 60}});
            const auto places = [&](double widest) { // y of rows, in the middle of the square
                std::vector<double> out;
                const Loops found = loops(square, {InfillPattern::rows, 0, spacing, kWidth, 0, widest});
                for (std::size_t l = 0; l < found.size(); ++l)
                    for (std::size_t i = 0; i < found[l].size(); ++i) {
                        const geom::Vec2 a = found[l][i], b = found[l][(i + 1) % found[l].size()];
                        if ((a.x < 30) != (b.x < 30)) out.push_back((a.y + b.y) / 2);
                    }
                std::sort(out.begin(), out.end());
                return out;
            };
            const auto plain = places(0), near = places(gap);
            for (const double y : plain)
                EXPECT_TRUE(y < 1 || y > 59 || // along the outline
                            std::any_of(near.begin(), near.end(), [&](double p) { return std::abs(p - y) < 0.02; }))
                    << spacing << " " << gap << " " << y;
            for (std::size_t i = 1; i < near.size(); ++i)
                EXPECT_LE(near[i] - near[i - 1] - kWidth, std::max(gap, 2.75 * kWidth) + 0.02) // room for three
                    << spacing << " " << gap;
        }
}

// Lines of a spacing and of half of it side by side: what is even goes on, nothing crosses, nothing stands alone.
TEST(Infill, PartsOfDifferentSpacingAreOne) {
    const Loops all = test::loop({{0, 0}, {60, 0}, {60, 60}, {0, 60}});
    const Loops island = test::loop({{20, 17}, {41, 20}, {40, 43}, {18, 40}});
    const Loops rest = polygon::subtract(all, island);
    for (const double parted : {3.0, 2.0, 4.0 / 3, 1.0})
        for (const double angle : {0.0, 0.3, 0.7853981633974483, 1.2}) {
            const Lines coarse{InfillPattern::rows, angle, 4, kWidth, 0},
                fine{InfillPattern::rows, angle, 4, kWidth, 0, parted};
            const Task parts[] = {{&island, fine}, {&rest, coarse}};
            const Loops found = loops(all, parts);
            EXPECT_TRUE(polygon::is_simple(found));
            for (const Loops& part : polygon::split(found).part) {
                const Loops near = polygon::subtract(polygon::offset(part, kWidth), polygon::offset(all, -kWidth));
                EXPECT_FALSE(near.empty()) << "a loop away from the outline, angle " << angle;
            }
        }
}

TEST(Infill, HollowAreasStayEmpty) {
    for (const InfillPattern pattern : {InfillPattern::rows, InfillPattern::wave, InfillPattern::concentric})
        for (const Loops& area : random_areas(3, 20)) {
            const Lines hollow = lines_of(pattern, 1, kHollow);
            EXPECT_TRUE(loops(area, hollow).empty());
            const std::vector<Task> parts{{&area, hollow}, {&area, hollow}};
            EXPECT_TRUE(loops(area, parts).empty());
        }
}

} // namespace
} // namespace filum::infill

namespace filum::infill {
namespace {

TEST(Infill, DensityOfAPrism) {
    for (const double side : {7.4, 12.3, 25.4, 50.0})
        for (const double density : {0.1, 0.15, 0.2, 0.4}) {
            const Loops square = test::loop({{1, 2}, {1 + side, 2}, {1 + side, 2 + side}, {1, 2 + side}});
            std::vector<Task> tasks;
            for (int layer = 0; layer < 6; ++layer)
                tasks.push_back(
                    {&square,
                     {polygon::InfillPattern::rows, (layer % 2 == 0 ? 1 : 3) * 0.7853981633974483, 0, kWidth, 0}});
            const double spacing = spacing_for(tasks, density, kWidth);
            double laid = 0;
            for (Task t : tasks) {
                t.lines.spacing = spacing;
                laid += kWidth * length(loops(square, t.lines)) / 6;
            }
            EXPECT_NEAR(laid / (side * side), density, 0.02 * density) << side << " spacing " << spacing;
        }
}

} // namespace
} // namespace filum::infill
