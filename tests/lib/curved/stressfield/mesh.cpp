#include "mesh/read.hpp"
#include "stressfield/elements.hpp"
#include "stressfield/read.hpp"
#include "stressfield/stencil.hpp"

#include "parts.hpp"

#include <gtest/gtest.h>

namespace filum::stressfield {
namespace {

const std::vector<Shape> kSolids = {Shape::tet4,   Shape::tet10,   Shape::hex8,    Shape::hex20,
                                    Shape::wedge6, Shape::wedge15, Shape::pyramid5};

// One element whose nodes are not in a box of its own axes.
Samples element(Shape shape) {
    std::vector<Vec3> corners;
    std::vector<std::array<int, 2>> edges;
    const std::vector<Vec3> box = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0},
                                   {0, 0, 5}, {2, 0, 5}, {2, 3, 5}, {0, 3, 5}};
    if (shape == Shape::tet4 || shape == Shape::tet10) {
        corners = {box[0], box[1], box[3], box[4]};
        edges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
    } else if (shape == Shape::hex8 || shape == Shape::hex20) {
        corners = box;
        edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
    } else if (shape == Shape::pyramid5) {
        corners = {box[0], box[1], box[2], box[3], box[4]};
    } else {
        corners = {box[0], box[1], box[3], box[4], box[5], box[7]};
        edges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}};
    }
    Samples out;
    for (const Vec3& p : corners) out.points.push_back({p.x + 0.3 * p.y, p.y + 0.1 * p.z, p.z - 0.2 * p.x});
    if (node_count(shape) > corners.size())
        for (const auto& [a, b] : edges)
            out.points.push_back(0.5 *
                                 (out.points[static_cast<std::size_t>(a)] + out.points[static_cast<std::size_t>(b)]));
    out.elements.push_back({shape, 0});
    for (std::uint32_t i = 0; i < out.points.size(); ++i) out.nodes.push_back(i);
    return out;
}

// A small triangle about each of these points.
surface::Surface specks(const std::vector<Vec3>& at) {
    mesh::Mesh m;
    for (const Vec3& p : at) {
        const auto n = static_cast<std::uint32_t>(m.vertices.size());
        m.vertices.insert(m.vertices.end(), {p, p + Vec3{0.01, 0, 0}, p + Vec3{0, 0.01, 0}});
        m.triangles.push_back({n, n + 1, n + 2});
    }
    Notes notes;
    return surface::connect(std::move(m), notes);
}

TEST(Mesh, AffineFieldsAreExactInEveryElement) {
    for (const Shape shape : kSolids) {
        const Samples one = element(shape);
        Vec3 middle;
        for (const Vec3& p : one.points) middle = middle + (1.0 / static_cast<double>(one.points.size())) * p;
        std::vector<Vec3> at = {middle};
        for (const Vec3& p : one.points) at.push_back(middle + 0.7 * (p - middle));
        const auto s = specks(at);
        const auto f = [](const Vec3& p) { return 1 + 2 * p.x - 3 * p.y + 0.5 * p.z; };
        std::vector<double> nodes;
        for (const Vec3& p : one.points) nodes.push_back(f(p));
        const auto stencils = in_mesh(s, one, 0, 1);
        for (std::size_t v = 0; v < s.vertices.size(); ++v) {
            EXPECT_EQ(stencils.gap[v], 0) << static_cast<int>(shape);
            EXPECT_NEAR(value(stencils, v, nodes), f(s.vertices[v]), 1e-12) << static_cast<int>(shape);
        }
    }
}

TEST(Mesh, SkinIsClosedAndFacesOut) {
    for (const Shape shape : kSolids) {
        const Samples one = element(shape);
        const Skin s = skin(one);
        double volume = 0;
        for (const auto& t : s.triangles)
            volume += dot(one.points[t[0]], cross(one.points[t[1]], one.points[t[2]])) / 6;
        const double box = 30 * (1 - 0.2 * 0.1 * 0.3); // the shear's determinant
        const double share = shape == Shape::tet4 || shape == Shape::tet10       ? 1.0 / 6
                             : shape == Shape::wedge6 || shape == Shape::wedge15 ? 1.0 / 2
                             : shape == Shape::pyramid5                          ? 1.0 / 3
                                                                                 : 1;
        EXPECT_NEAR(volume, share * box, 1e-9) << static_cast<int>(shape);
    }
}

TEST(Mesh, AFaceThatTwoElementsShareIsNotOfTheSkin) {
    Samples two = element(Shape::tet4);
    two.points.push_back({5, 5, 5});
    two.elements.push_back({Shape::tet4, 4});
    two.nodes.insert(two.nodes.end(), {3, 2, 1, 4});
    EXPECT_EQ(skin(two).triangles.size(), 6U);
    two.elements.push_back({Shape::triangle3, 8});
    two.nodes.insert(two.nodes.end(), {0, 1, 2});
    const Skin s = skin(two);
    ASSERT_EQ(s.triangles.size(), 7U);
    EXPECT_FALSE(s.shell[5]);
    EXPECT_TRUE(s.shell[6]);
}

// Of CalculiX 2.20, one element of every kind, 10 mm apart, that bends: its shear stress is y MPa, exactly so in the
// elements with nodes on their edges, and 1.5 MPa in the middle of the others; 2 MPa pull along z.
TEST(Mesh, ElementsOfCalculix) {
    const auto bytes = mesh::load(FILUM_EXAMPLES "/../tests/lib/curved/stressfield/elements.frd");
    Notes notes;
    const Samples samples = read(bytes.view(), "it", {}, notes);
    ASSERT_EQ(samples.elements.size(), 6U);
    const std::vector<Vec3> at = {{1.2, 1.7, 2.9},  {10.5, 0.7, 2.2}, {20.4, 0.5, 0.9},
                                  {31.2, 1.5, 2.9}, {40.5, 0.7, 2.2}, {50.4, 0.5, 0.9}};
    const auto s = specks(at);
    const auto stencils = in_mesh(s, samples, 0, 1);
    for (std::size_t e = 0; e < 6; ++e)
        for (std::size_t v = 3 * e; v < 3 * e + 3; ++v) {
            std::vector<double> shear, pull;
            for (const auto& t : samples.cases[0].tensors) {
                shear.push_back(t[3]);
                pull.push_back(t[2]);
            }
            EXPECT_NEAR(value(stencils, v, shear), e < 3 ? s.vertices[v].y : 1.5, 1e-3) << e;
            EXPECT_NEAR(value(stencils, v, pull), 2, 1e-3) << e;
        }
}

// A plate of bricks, 0.3 mm thick, with +1 on its top and -1 below.
Samples plate(std::vector<double>& side) {
    Samples out;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j <= 4; ++j)
            for (int i = 0; i <= 4; ++i) {
                out.points.push_back({1.0 * i, 1.0 * j, k == 0 ? -0.3 : 0});
                side.push_back(k == 0 ? -1 : 1);
            }
    for (std::uint32_t j = 0; j < 4; ++j)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = 5 * j + i;
            out.elements.push_back({Shape::hex8, static_cast<std::uint32_t>(out.nodes.size())});
            out.nodes.insert(out.nodes.end(), {a, a + 1, a + 6, a + 5, a + 25, a + 26, a + 31, a + 30});
        }
    return out;
}

TEST(Mesh, OffAThinWallItsNearSideSpeaks) {
    std::vector<double> side;
    const Samples bricks = plate(side);
    for (const bool turned : {false, true})
        for (const double z : {0.0, 0.1, 0.29}) {
            auto flat = square(7, 4);
            mesh::Mesh m{flat.vertices, flat.triangles};
            for (auto& p : m.vertices) p.z = z;
            if (turned)
                for (auto& t : m.triangles) std::swap(t[1], t[2]);
            Notes notes;
            const auto s = surface::connect(std::move(m), notes);
            const auto stencils = in_mesh(s, bricks, 0, 2);
            for (std::size_t v = 0; v < s.vertices.size(); ++v) {
                EXPECT_NEAR(stencils.gap[v], z, 1e-12);
                EXPECT_NEAR(value(stencils, v, side), 1, 1e-12);
            }
        }
}

// A surface that cuts deep into the wall, as one off by more than the wall does, faces the side that it is of.
TEST(Mesh, WithinTheWallTheElementSpeaks) {
    std::vector<double> side;
    const Samples bricks = plate(side);
    auto flat = square(7, 4);
    mesh::Mesh m{flat.vertices, flat.triangles};
    for (auto& p : m.vertices) p.z = -0.15 - 0.05 * p.x / 4;
    Notes notes;
    const auto s = surface::connect(std::move(m), notes);
    const auto stencils = in_mesh(s, bricks, 0, 1);
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        EXPECT_NEAR(value(stencils, v, side), 1 + 2 * s.vertices[v].z / 0.3, 1e-12);
}

TEST(Mesh, BeyondReachNothingSpeaks) {
    std::vector<double> side;
    const Samples bricks = plate(side);
    auto flat = square(2, 4);
    mesh::Mesh m{flat.vertices, flat.triangles};
    for (auto& p : m.vertices) p.z = 0.7;
    Notes notes;
    const auto s = surface::connect(std::move(m), notes);
    const auto none = in_mesh(s, bricks, 0, 1), some = in_mesh(s, bricks, 0.8, 1);
    EXPECT_TRUE(none.sample.empty());
    EXPECT_NEAR(none.gap[4], 0.7, 1e-12);
    EXPECT_FALSE(some.sample.empty());
}

TEST(Mesh, ShellsSpeakToBothSides) {
    Samples shell;
    shell.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    shell.elements.push_back({Shape::quad4, 0});
    shell.nodes = {0, 3, 2, 1};
    const auto s = square(3, 4);
    const auto stencils = in_mesh(s, shell, 0, 1);
    for (std::size_t v = 0; v < s.vertices.size(); ++v)
        EXPECT_NEAR(value(stencils, v, {0, 4, 8, 4}), s.vertices[v].x + s.vertices[v].y, 1e-12);
}

} // namespace
} // namespace filum::stressfield
