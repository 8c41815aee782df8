// Paths of field and hybrid do not depend on what is no part of a surface: the last bits of its vertices, the order of
// triangles and vertices, and the choice of axes.
#include "surfpath/surfpath.hpp"

#include "../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <random>

namespace filum::surfpath::perturbed {
namespace {

constexpr double kMoved = 1e-9;      // mm, by which vertices move
constexpr double kSameShare = 0.002; // of the area, by which coverage and overlap may differ

// Copies of each surface: FILUM_COPIES, otherwise one.
int copies() {
    const char* asked = std::getenv("FILUM_COPIES");
    return asked != nullptr ? std::atoi(asked) : 1;
}

// A surface with the direction that its lines follow.
struct Part {
    mesh::Mesh mesh;
    Vec3 reference{1, 0, 0};
};

mesh::Mesh half_cylinder() {
    return surface::grid(std::numbers::pi, 12, 18, 12, [](geom::Vec2 p) {
        return Vec3{6 * std::cos(p.x), 6 * std::sin(p.x), p.y};
    });
}

mesh::Mesh saddle() {
    return surface::grid(16, 16, 16, 16, [](geom::Vec2 p) {
        const double x = p.x - 8, y = p.y - 8;
        return Vec3{x, y, (x * x - y * y) / 16};
    });
}

mesh::Mesh plate() { return surface::flat_grid(16, 12, 16, 12); }

mesh::Mesh plate_with_hole() {
    const auto hole = [](geom::Vec2 p) { return std::hypot(p.x - 12, p.y - 12) < 4; };
    return surface::pierced_grid(
        24, 24, 24, 24,
        [](geom::Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
        hole);
}

// Rotates by a quarter turn about each axis as often as the bits of `random` say, with the rounding of cosines.
Vec3 rotated(Vec3 p, std::uint32_t random) {
    const double quarter = std::numbers::pi / 2;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = quarter * (random >> 2 * axis & 3), c = std::cos(a), s = std::sin(a);
        p = Vec3{p.y, c * p.z - s * p.x, s * p.z + c * p.x};
    }
    return p;
}

// The same surface: its vertices moved by nanometres, it by right angles and some millimetres, both lists in another
// order.
Part copy(Part part, std::mt19937& random) {
    std::uniform_real_distribution<double> by(-kMoved, kMoved), far(-100, 100);
    const auto turns = static_cast<std::uint32_t>(random());
    const Vec3 shift{far(random), far(random), far(random)};
    mesh::Mesh& mesh = part.mesh;
    for (auto& v : mesh.vertices) v = rotated(v, turns) + shift + Vec3{by(random), by(random), by(random)};
    part.reference = rotated(part.reference, turns);
    std::vector<std::uint32_t> to(mesh.vertices.size());
    std::iota(to.begin(), to.end(), 0U);
    std::shuffle(to.begin(), to.end(), random);
    auto vertices = mesh.vertices;
    for (std::size_t i = 0; i < to.size(); ++i) vertices[to[i]] = mesh.vertices[i];
    mesh.vertices = std::move(vertices);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    for (auto& t : mesh.triangles) {
        for (auto& v : t) v = to[v];
        std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    return part;
}

// What a path is worth.
struct Worth {
    std::size_t strokes = 0;
    double uncovered = 0, twice = 0; // shares of the area
    double length = 0;               // mm
};

Worth worth(const Part& part, Algorithm algorithm, double turn) {
    Notes notes;
    const surface::Sheet sheet{surface::connect(part.mesh, notes), {}, {}};
    Options o{.algorithm = algorithm};
    o.follow.angle = algorithm == Algorithm::field ? 1 : 0;
    o.follow.turn = turn;
    o.follow.reference = part.reference;
    Plan plan = plan_paths(sheet, o);
    finish(sheet.surface, plan, o);
    Worth out{plan.strokes.size(), 0, 0, 0};
    for (const Stroke& stroke : plan.strokes)
        for (const Section& section : stroke.sections) out.length += surface::curve::length(section.line);
    for (const Fact& f : plan.facts) {
        if (f.name == "uncovered") out.uncovered = f.value / surface::area(sheet.surface);
        if (f.name == "laid-twice") out.twice = f.value / surface::area(sheet.surface);
    }
    return out;
}

void compare(const Part& part, Algorithm algorithm, double turn, std::mt19937& random) {
    const Worth wanted = worth(part, algorithm, turn);
    for (int i = 0; i < copies(); ++i) {
        const Worth got = worth(copy(part, random), algorithm, turn);
        SCOPED_TRACE(testing::Message() << "copy " << i << ", turned by " << turn);
        EXPECT_EQ(got.strokes, wanted.strokes);
        EXPECT_NEAR(got.uncovered, wanted.uncovered, kSameShare);
        EXPECT_NEAR(got.twice, wanted.twice, kSameShare);
        EXPECT_NEAR(got.length, wanted.length, kSameShare * wanted.length);
    }
}

TEST(Perturbed, CopiesOfASurfaceGetTheSamePathAlongAnAngle) {
    std::mt19937 random(11);
    for (const mesh::Mesh& mesh : {half_cylinder(), saddle(), plate()})
        for (const double turn : {0.0, std::numbers::pi / 6}) compare({mesh}, Algorithm::field, turn, random);
}

TEST(Perturbed, CopiesOfASurfaceGetTheSameHybridPath) {
    std::mt19937 random(12);
    for (const mesh::Mesh& mesh : {saddle(), plate_with_hole()}) compare({mesh}, Algorithm::hybrid, 0, random);
}

} // namespace
} // namespace filum::surfpath::perturbed
