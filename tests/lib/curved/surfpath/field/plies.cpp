// Plies at an angle to an axis on surfaces of revolution, where the lines are known: helices and loxodromes.
#include "surfpath/field/stripes.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "geom/angle.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace filum::surfpath::field {
namespace {

using geom::Vec2;

constexpr double kTurn = 45 * geom::kDegree;

// A strip of a surface of revolution about z, eighty degrees round: the point at angle a and way w along the
// meridian, and which way the meridian goes there.
struct Revolved {
    std::function<Vec3(double a, double w)> point;
    double way = 30;
};

Vec3 at(double r, double a, double z) { return {r * std::cos(a), r * std::sin(a), z}; }

Revolved cylinder() {
    return {[](double a, double w) { return at(20, a, w); }};
}
Revolved cone() { // of 20 degrees
    return {[](double a, double w) { return at(15 + w * std::sin(0.35), a, w * std::cos(0.35)); }};
}
Revolved fan() { // a flat cone, of 70 degrees: meridians spread
    return {[](double a, double w) { return at(8 + w * std::sin(1.22), a, w * std::cos(1.22)); }};
}
Revolved sphere() { // 43 degrees of latitude about the equator
    return {[](double a, double w) { return at(40 * std::cos(w / 40 - 0.4), a, 40 * std::sin(w / 40 - 0.4)); }};
}

// As a grid of rectangles halved alike, or with points moved about and halved either way.
Surface surface_of(const Revolved& r, bool uneven) {
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    const double a = 1.4, b = r.way;
    const int n = 90, m = 80;
    std::vector<Vec2> off;
    auto mesh = surface::grid(a, b, n, m, [&](Vec2 p) {
        const bool inner = p.x > 0 && p.x < a && p.y > 0 && p.y < b;
        const Vec2 q = uneven && inner ? Vec2{p.x + 0.5 * a / n * unit(), p.y + 0.5 * b / m * unit()} : p;
        return r.point(q.x, q.y);
    });
    Notes notes;
    return surface::connect(mesh, notes);
}

// The direction at `turn` from the meridian, as the axis z laid onto the surface of normal n has it.
Vec3 loxodrome(const Vec3& n) {
    const Vec3 up = Vec3{0, 0, 1} - n.z * n, u = 1 / norm(up) * up;
    return std::cos(kTurn) * u + std::sin(kTurn) * cross(n, u);
}

struct Off {
    double mean = 0, most = 0; // degrees
    double length = 0;         // mm of lines
};

// Where two lines are born, and turn into each other.
std::vector<Vec3> where_born(const Surface& s, const Stripes& stripes) {
    std::vector<Vec3> out;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        if (singular(s, stripes, t)) out.push_back(s.vertices[s.triangles[t][0]]);
    return out;
}

// Of what is more than a spacing from births.
Off off(const Surface& s, const std::vector<Line>& lines, const std::vector<Vec3>& births) {
    Off out;
    for (const Line& l : lines)
        for (std::size_t i = 1; i < l.size(); ++i) {
            const Vec3 d = l[i] - l[i - 1];
            const double length = norm(d);
            const auto at = [&](const Vec3& b) { return distance(b, l[i]) < 1; };
            if (!(length > 1e-6) || std::any_of(births.begin(), births.end(), at)) continue;
            const Vec3 n = surface::normal(s, l.places[i - 1].triangle);
            const double angle = std::acos(std::min(1.0, std::abs(dot(d, loxodrome(n))) / length));
            out.mean += length * geom::degrees(angle);
            out.length += length;
            out.most = std::max(out.most, geom::degrees(angle));
        }
    out.mean /= out.length;
    return out;
}

struct PlyResult {
    double directions = 0; // degrees: the most that these are off
    Off lines;
    double spacing = 0; // mm: area over length
    std::size_t births = 0;
};

PlyResult ply(const Revolved& shape, bool uneven) {
    surface::Sheet sheet{surface_of(shape, uneven), {}, {}};
    const Surface& s = sheet.surface;
    const Cells cells = surface::directions::cells(s);
    DirectionMix o;
    o.angle = 1;
    o.turn = kTurn;
    o.reference = {0, 0, 1};
    const auto d = smooth(s, cells, prescribed(sheet, cells, o), 0.2, 2.4);
    PlyResult out;
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        out.directions =
            std::max(out.directions,
                     geom::degrees(std::acos(std::min(1.0, std::abs(dot(d.along[v], loxodrome(cells.normal[v])))))));
    const auto found = stripes(s, cells, d.along, {.stiff = kKeepAngle});
    const auto all = lines(s, found);
    const auto born = where_born(s, found);
    out.births = born.size();
    out.lines = off(s, all, born);
    out.spacing = surface::area(s) / off(s, all, {}).length;
    return out;
}

class Plies : public testing::TestWithParam<bool> {};

TEST_P(Plies, OnACylinderAreHelices) {
    const PlyResult f = ply(cylinder(), GetParam());
    EXPECT_EQ(f.births, 0U);
    EXPECT_LT(f.directions, 0.5);
    EXPECT_LT(f.lines.most, 0.5);
}

TEST_P(Plies, OnAConeAreLoxodromes) {
    const PlyResult f = ply(cone(), GetParam());
    EXPECT_LT(f.directions, 0.5);
    EXPECT_LT(f.lines.mean, 0.5);
    EXPECT_LT(f.births, 40U);
    EXPECT_NEAR(f.spacing, 1, 0.02);
}

TEST_P(Plies, OnASphereAreLoxodromes) {
    const PlyResult f = ply(sphere(), GetParam());
    EXPECT_LT(f.directions, 0.5);
    EXPECT_LT(f.lines.mean, 0.5);
    EXPECT_LT(f.births, 40U);
    EXPECT_NEAR(f.spacing, 1, 0.02);
}

// Of a second ply births lie beside those of the first, and are about as many.
TEST_P(Plies, AreBornApart) {
    surface::Sheet sheet{surface_of(fan(), GetParam()), {}, {}};
    const Surface& s = sheet.surface;
    const Cells cells = surface::directions::cells(s);
    DirectionMix o;
    o.angle = 1;
    o.reference = {0, 0, 1};
    const auto d = smooth(s, cells, prescribed(sheet, cells, o), 0.2, 2.4);
    const auto born = births(s, stripes(s, cells, d.along, {.stiff = kKeepAngle}));
    const auto then = births(s, stripes(s, cells, d.along, {.stiff = kKeepAngle, .apart = born}));
    ASSERT_GE(born.size(), 3U);
    EXPECT_NEAR(static_cast<double>(then.size()), static_cast<double>(born.size()), 2);
    double sum = 0;
    for (const Vec3& p : then) {
        double least = 1e9;
        for (const Vec3& q : born) least = std::min(least, distance(p, q));
        EXPECT_GT(least, 0.5);
        sum += least;
    }
    EXPECT_GT(sum, 2 * static_cast<double>(then.size())); // two spacings, in the mean
}

INSTANTIATE_TEST_SUITE_P(Meshes, Plies, testing::Bool());

} // namespace
} // namespace filum::surfpath::field
