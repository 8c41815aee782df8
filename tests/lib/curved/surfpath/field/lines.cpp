// What holds of lines along any field on any surface.
#include "surfpath/field/stripes.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "base/error.hpp"
#include "geom/angle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace filum::surfpath::field {
namespace {

using surface::kNone;

// A rectangle with waves, its points moved about, some cells left out as holes.
Surface rough(std::mt19937& random) {
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const double a = 20 + 20 * unit(), b = 15 + 15 * unit(), high = 4 * unit(), wave = 0.1 + 0.2 * unit();
    const double shear = 0.3 * unit(), x = a * (0.3 + 0.4 * unit()), y = b * (0.3 + 0.4 * unit()), r = 3 * unit();
    const int n = static_cast<int>(a / 0.8), m = static_cast<int>(b / 0.8);
    auto mesh = surface::pierced_grid(
        a, b, n, m,
        [&](geom::Vec2 p) {
            const double u = p.x + 0.3 * (unit() - 0.5), v = p.y + 0.3 * (unit() - 0.5);
            return Vec3{u + shear * v, v, high * std::sin(wave * u) * std::cos(wave * v)};
        },
        [&](geom::Vec2 p) { return std::hypot(p.x - x, p.y - y) < r; });
    Notes notes;
    return surface::connect(mesh, notes);
}

struct TracedField {
    Surface surface;
    Stripes stripes;
    std::vector<Line> lines;
};

TracedField laid(Surface s, const DirectionMix& o, double spacing) {
    surface::Sheet sheet{std::move(s), {}, {}};
    const Cells cells = surface::directions::cells(sheet.surface);
    const auto d = smooth(sheet.surface, cells, prescribed(sheet, cells, o), 0.2 * spacing, 2.4);
    TracedField out{sheet.surface, stripes(sheet.surface, cells, d.along, {.spacing = spacing}), {}};
    out.lines = lines(out.surface, out.stripes);
    return out;
}

DirectionMix angle(double turn) {
    DirectionMix out;
    out.angle = 1;
    out.turn = turn;
    return out;
}

bool on_rim(const Surface& s, const surface::curve::Place& p) {
    for (std::uint32_t h = 3 * p.triangle; h < 3 * p.triangle + 3; ++h) {
        if (s.twin[h] != kNone) continue;
        const Vec3 a = s.vertices[s.tail(h)], d = s.vertices[s.head(h)] - a;
        if (norm(cross(d, p.point - a)) < 1e-9 * dot(d, d)) return true;
    }
    return false;
}

// Lines end at rims only, every stretch lies in its triangle, and there is as much of them as the spacing wants.
TEST(Lines, EndAtRimsAndAreASpacingApartInTheMean) {
    std::mt19937 random(3);
    for (int round = 0; round < 12; ++round) {
        const TracedField l = laid(rough(random), angle(round * 15 * geom::kDegree), 1);
        double length = 0;
        for (const Line& line : l.lines) {
            length += surface::curve::length(line);
            for (std::size_t i = 0; i + (line.closed ? 0 : 1) < line.size(); ++i)
                for (const std::size_t k : {i, (i + 1) % line.size()}) {
                    const std::uint32_t t = line.places[i].triangle;
                    const Vec3 p = line[k];
                    EXPECT_LT(distance(surface::nearest_in(l.surface, t, p), p), 1e-9);
                }
            if (line.closed) continue;
            EXPECT_TRUE(on_rim(l.surface, line.places.front()));
            EXPECT_TRUE(on_rim(l.surface, line.places.back()));
        }
        EXPECT_NEAR(surface::area(l.surface) / length, 1, 0.03) << "round " << round;
    }
}

// The sides of the lines are told apart by the sign of the stripes at the vertices: an edge is crossed as often as this
// says.  So lines never cross, and none is lost.
TEST(Lines, PartTheVerticesByTheSignOfTheirStripes) {
    std::mt19937 random(8);
    const TracedField l = laid(rough(random), angle(0.4), 1);
    std::vector<std::size_t> crossed(l.surface.twin.size(), 0);
    const auto edge = [&](const Vec3& p, std::uint32_t t) {
        std::uint32_t best = 3 * t;
        double least = 1e300;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const Vec3 a = l.surface.vertices[l.surface.tail(h)], d = l.surface.vertices[l.surface.head(h)] - a;
            if (const double off = norm(cross(d, p - a)) / norm(d); off < least) {
                least = off;
                best = h;
            }
        }
        const std::uint32_t twin = l.surface.twin[best];
        return twin == kNone ? best : std::min(best, twin);
    };
    for (const Line& line : l.lines)
        for (std::size_t i = 0; i < line.size(); ++i) ++crossed[edge(line[i], line.places[i].triangle)];
    for (std::uint32_t h = 0; h < crossed.size(); ++h) {
        if (l.surface.twin[h] != kNone && l.surface.twin[h] < h) continue;
        const bool differ =
            (l.stripes.phase[l.surface.tail(h)].real() > 0) != (l.stripes.phase[l.surface.head(h)].real() > 0);
        EXPECT_EQ(crossed[h] % 2 == 1, differ) << h;
    }
}

// Along a strip of any width there are as many lines as fit best, an odd number as well as an even one, and also where
// they lie just on rows of vertices.
TEST(Lines, AlongAStripAreAsManyAsFitBest) {
    for (const double width : {1.4, 2.0, 2.3, 3.0, 3.3, 4.0, 4.7, 5.0, 7.4, 11.2}) {
        const auto mesh = surface::grid(30, width, 60, static_cast<int>(std::ceil(2 * width)), [](geom::Vec2 p) {
            return Vec3{p.x, p.y, 0};
        });
        Notes notes;
        const TracedField l = laid(surface::connect(mesh, notes), angle(0), 1);
        EXPECT_EQ(l.lines.size(), static_cast<std::size_t>(std::lround(width))) << width;
    }
}

// A fan of 60 degrees from 20 to 50 mm: straight rays spread from 21 to 52 of them, so at least 15 pairs are born.
TEST(Lines, AreBornInTwosWhereDirectionsSpread) {
    auto mesh = surface::grid(1, 30, 60, 40, [](geom::Vec2 p) {
        const double a = geom::kDegree * 60 * (0.5 - p.x), r = 20 + p.y;
        return Vec3{r * std::cos(a), r * std::sin(a), 0};
    });
    Notes notes;
    surface::Sheet sheet{surface::connect(mesh, notes), {}, {}};
    surface::Field out{"direction", {}, 3};
    for (const Vec3& p : sheet.surface.vertices) out.values.insert(out.values.end(), {p.x, p.y, 0});
    sheet.fields.push_back(out);
    const Cells cells = surface::directions::cells(sheet.surface);
    DirectionMix o;
    o.given = 1;
    const auto d = smooth(sheet.surface, cells, prescribed(sheet, cells, o), 0.2, 2.4);
    EXPECT_LT(d.tightest, 0.01);
    const auto all = lines(sheet.surface, stripes(sheet.surface, cells, d.along, {}));
    std::size_t both = 0, outer = 0;
    for (const Line& l : all) {
        const bool a = norm(l[0]) < 21, b = norm(l[l.size() - 1]) < 21;
        both += a != b ? 1 : 0;
        outer += !a && !b ? 1 : 0;
    }
    EXPECT_NEAR(both, 21, 2);
    EXPECT_NEAR(outer, 15, 3);
}

// Where nothing is wanted tighter, weights stay; where a whirl is wanted, the field gives it up near its middle.
TEST(Directions, BendNoTighterThanAskedWhereTheyCan) {
    auto mesh = surface::grid(20, 20, 50, 50, [](geom::Vec2 p) { return Vec3{p.x - 10, p.y - 10, 0}; });
    Notes notes;
    surface::Sheet sheet{surface::connect(mesh, notes), {}, {}};
    surface::Field kink{"direction", {}, 3}; // along x on one side, turned by 60 degrees on the other
    for (const Vec3& p : sheet.surface.vertices)
        kink.values.insert(kink.values.end(), {p.x < 0 ? 1.0 : 0.5, p.x < 0 ? 0 : std::sqrt(0.75), 0});
    sheet.fields.push_back(kink);
    const Cells cells = surface::directions::cells(sheet.surface);
    DirectionMix o;
    o.given = 1;
    const auto rough = smooth(sheet.surface, cells, prescribed(sheet, cells, o), 0.2, 0.01);
    EXPECT_EQ(rough.given_up, 0);
    EXPECT_GT(rough.tightest, 1);
    const auto gentle = smooth(sheet.surface, cells, prescribed(sheet, cells, o), 0.2, 4);
    EXPECT_EQ(gentle.tight, 0);
    EXPECT_LE(gentle.tightest, 0.25);
    EXPECT_GT(gentle.given_up, 0);
    EXPECT_LT(gentle.given_up, 200);
    for (std::size_t v = 0; v < sheet.surface.vertices.size(); ++v)
        EXPECT_TRUE(std::abs(sheet.surface.vertices[v].x) <= 8 ||
                    std::abs(dot(gentle.along[v], kink.vector(v))) > std::cos(2 * geom::kDegree));
}

TEST(Directions, SayWhatIsMissing) {
    Notes notes;
    const surface::Sheet sheet{surface::connect(surface::flat_grid(4, 4, 4, 4), notes), {}, {}};
    const Cells cells = surface::directions::cells(sheet.surface);
    DirectionMix o;
    o.stress = 1;
    EXPECT_THROW((void)prescribed(sheet, cells, o), Error);
    o = {};
    o.given = 1;
    EXPECT_THROW((void)prescribed(sheet, cells, o), Error);
    o = angle(0);
    o.reference = {0, 0, 1}; // stands upright everywhere
    EXPECT_THROW((void)prescribed(sheet, cells, o), Error);
}

} // namespace
} // namespace filum::surfpath::field
