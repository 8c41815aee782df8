// Alignment with fields of stress that are known.
#include "metrics/surface/load.hpp"
#include "base/error.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::number;
using paths::Vec2;

using std::numbers::pi;

// A plate with load cases; `direction` and `stress` per vertex, its sign at random.
struct Loaded {
    filum::surface::Sheet sheet{surfaces::sheet(10, 10, 20, 20, 9).surface, {}, {}, {}};
    std::mt19937 random{1};
    double unit() { return static_cast<double>(random()) / 4294967296.0; }
    void add(
        const std::string& name, const std::function<Vec3(const Vec3&)>& direction,
        const std::function<double(const Vec3&)>& stress = [](const Vec3&) { return 1.0; }) {
        filum::surface::Field s1{"stress." + name + ".s1", {}}, d1{"stress." + name + ".d1", {}, 3};
        for (const Vec3& v : sheet.surface.vertices) {
            const Vec3 d = (unit() < 0.5 ? -1 : 1) * direction(v);
            s1.values.push_back(stress(v));
            d1.values.insert(d1.values.end(), {d.x, d.y, d.z});
        }
        sheet.fields.push_back(s1);
        sheet.fields.push_back(d1);
    }
    figures::Figures along_x() {
        return measure(paths::fibres(paths::parallel(0, 10, 0.5, 1, 10)), sheet, {}, false, 1).figures;
    }
};

Vec3 at(double angle, double tilt = 0) {
    return {std::cos(tilt) * std::cos(angle), std::cos(tilt) * std::sin(angle), std::sin(tilt)};
}

TEST(Load, OfOneDirection) {
    Loaded p;
    p.add("x", [](const Vec3&) { return at(pi / 6); });
    const auto f = p.along_x();
    EXPECT_NEAR(number(f, "paper: mean |t . d1| of the best case at each point"), std::cos(pi / 6), 1e-9);
    EXPECT_NEAR(number(f, "|t . d1|", "load case x"), std::cos(pi / 6), 1e-9);
    EXPECT_NEAR(number(f, "along the surface", "load case x"), std::cos(pi / 6), 1e-9);
    EXPECT_NEAR(number(f, "|t . d1|, upper bound", "load case x"), 1, 1e-9);
    EXPECT_EQ(number(f, "share within 15 degrees", "load case x"), 0);
    EXPECT_NEAR(number(f, "along the surface, at random", "load case x"), 2 / pi, 1e-4);
    EXPECT_NEAR(number(f, "paper: at random"), 2 / pi, 1e-4);
}

TEST(Load, OutOfTheSurface) {
    Loaded p;
    p.add("x", [](const Vec3&) { return at(0.2, pi / 3); });
    const auto f = p.along_x();
    EXPECT_NEAR(number(f, "|t . d1|", "load case x"), 0.5 * std::cos(0.2), 1e-9);
    EXPECT_NEAR(number(f, "|t . d1|, upper bound", "load case x"), 0.5, 1e-9);
    EXPECT_NEAR(number(f, "paper: upper bound"), 0.5, 1e-9);
    EXPECT_NEAR(number(f, "along the surface", "load case x"), std::cos(0.2), 1e-9);
    EXPECT_EQ(number(f, "share within 15 degrees", "load case x"), 1);
}

// What a path at random scores by the paper's figure: .637 of one field, .811 of two, .900 of two at right angles.
TEST(Load, BaselinesAtRandom) {
    Loaded two, crossed;
    two.add("x", [&](const Vec3&) { return at(2 * pi * two.unit()); });
    two.add("y", [&](const Vec3&) { return at(2 * pi * two.unit()); });
    crossed.add("x", [](const Vec3& v) { return at(v.x); });
    crossed.add("y", [](const Vec3& v) { return at(v.x + pi / 2); });
    EXPECT_NEAR(number(two.along_x(), "paper: at random"), 0.811, 0.01);
    EXPECT_NEAR(number(crossed.along_x(), "paper: at random"), 0.900, 1e-3);
}

TEST(Load, CasesAndWeights) {
    Loaded p;
    p.add(
        "a", [](const Vec3& v) { return at(v.y < 5 ? 0 : pi / 2); },
        [](const Vec3& v) { return v.y < 5 ? -9.0 : 1.0; });
    p.add("b", [](const Vec3& v) { return at(v.y < 5 ? pi / 2 : 0); });
    const auto f = p.along_x();
    // half of the path lies along either case: the paper takes the better one everywhere
    EXPECT_GT(number(f, "paper: mean |t . d1| of the best case at each point"), 0.97);
    EXPECT_NEAR(number(f, "along the surface", "load case a"), 0.5, 0.03);
    EXPECT_NEAR(number(f, "along the surface", "load case b"), 0.5, 0.03);
    EXPECT_NEAR(number(f, "along the surface, by |s1|", "load case a"), 0.9, 0.03);
    EXPECT_NEAR(number(f, "along the surface, by |s1|, least of cases"), 0.5, 0.03);
}

TEST(Load, UnknownStress) {
    Loaded p;
    p.add("a", [](const Vec3& v) { return v.y < 5 ? at(0) : Vec3{INFINITY, INFINITY, INFINITY}; });
    const auto f = p.along_x();
    EXPECT_NEAR(number(f, "along the surface", "load case a"), 1, 1e-9);
    EXPECT_NEAR(number(f, "share of the path with a known stress", "load case a"), 0.5, 0.05);
    Loaded none;
    EXPECT_TRUE(std::isnan(number(none.along_x(), "load cases")));
    Loaded wrong;
    wrong.sheet.fields.push_back({"stress.q.d1", std::vector<double>(wrong.sheet.surface.vertices.size(), 1.0)});
    EXPECT_THROW((void)load_cases(wrong.sheet), Error);
}

// Of two pulls across each other, 3 along x and 1 along y, the path along x has all of the greater, one along y a
// third; pressure is none.
TEST(Load, PullsCountByTheirSize) {
    Loaded p;
    p.add(
        "x", [](const Vec3&) { return at(0); }, [](const Vec3&) { return 3.0; });
    p.add("y", [](const Vec3&) { return at(pi / 2); });
    p.add(
        "pressed", [](const Vec3&) { return at(pi / 2); }, [](const Vec3&) { return -9.0; });
    const auto loads = load_cases(p.sheet);
    const Ground ground(p.sheet.surface, 1);
    const auto adequacy = [&](std::vector<Vec3> points) {
        toolpath::Span span{toolpath::Role::bead, 0, 0, 0, std::move(points), {1}, {1}, {}};
        Fibres fibres;
        add(fibres, span);
        return pull_adequacy(samples(fibres, ground, 0.25, 1), p.sheet.surface, loads);
    };
    EXPECT_NEAR(adequacy({{1, 5, 0}, {9, 5, 0}}), 1, 1e-9);
    EXPECT_NEAR(adequacy({{5, 1, 0}, {5, 9, 0}}), 1.0 / 3, 1e-9);
    const double a = std::atan2(3, 4);
    EXPECT_NEAR(adequacy({{1, 1, 0}, {9, 7, 0}}), std::cos(a), 1e-9);
    Loaded none;
    none.add(
        "pressed", [](const Vec3&) { return at(0); }, [](const Vec3&) { return -1.0; });
    EXPECT_TRUE(std::isnan(pull_adequacy({}, none.sheet.surface, load_cases(none.sheet))));
    EXPECT_EQ(pull(load_cases(none.sheet), 0, {1, 0, 0}).most, 0);
}

} // namespace
} // namespace filum::metrics::surface
