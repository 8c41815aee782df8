// Faces of more than three corners, of many shapes and in every format, have the area of their polygon.
//
// FILUM_POLYGONS=N tries N of each shape.
#include "mesh/polygons.hpp"

#include "mesh/place.hpp"
#include "mesh/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <sstream>

using namespace filum;
using geom::Vec2;
using geom::Vec3;

namespace polygons {

std::uint32_t trials() {
    const char* n = std::getenv("FILUM_POLYGONS");
    return n == nullptr ? 100 : static_cast<std::uint32_t>(std::strtoul(n, nullptr, 10));
}

double any(std::mt19937& chance) { return static_cast<double>(chance()) / 4294967296.0; }

double area(const std::vector<Vec2>& p) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i], p[(i + 1) % p.size()]);
    return sum / 2;
}

// Corners at random distances round a point; on some sides more corners.
std::vector<Vec2> star(std::mt19937& chance) {
    const auto n = static_cast<int>(4 + chance() % 30);
    std::vector<Vec2> out;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.9 * any(chance)) / n, far = 2 + 18 * any(chance);
        out.push_back({far * std::cos(angle), far * std::sin(angle)});
    }
    std::vector<Vec2> more;
    for (std::size_t i = 0; i < out.size(); ++i) {
        more.push_back(out[i]);
        if (chance() % 3 == 0) more.push_back(lerp(out[i], out[(i + 1) % out.size()], 0.5));
    }
    return more;
}

// Steps up and down on a grid: many corners in a line with others.
std::vector<Vec2> stairs(std::mt19937& chance) {
    std::vector<Vec2> out{{0, 0}};
    const auto n = static_cast<int>(2 + chance() % 12);
    out.push_back({static_cast<double>(n), 0});
    double before = 0;
    for (int i = n; i > 0; --i) {
        const double high = 1 + std::fmod(before + static_cast<double>(chance() % 3), 4); // another one than before
        before = high;
        out.push_back({static_cast<double>(i), high});
        out.push_back({static_cast<double>(i - 1), high});
    }
    return out;
}

// A square with a square hole, to which a doubled side leads.
std::vector<Vec2> keyhole(std::mt19937& chance) {
    const double x = 1 + 5 * any(chance), y = 1 + 5 * any(chance), s = 1 + 2 * any(chance);
    return {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {x, y}, {x, y + s}, {x + s, y + s}, {x + s, y}, {x, y}};
}

struct Posed {
    std::vector<Vec3> at;
    double bend;
};

// Turned anyhow, begun at any corner, and bent by a little.
Posed posed(std::vector<Vec2> p, std::mt19937& chance, double bend) {
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(chance() % p.size()), p.end());
    const auto map = mesh::rigid({360 * any(chance), 360 * any(chance), 360 * any(chance)}, {1, 2, 3});
    Posed out{{}, bend};
    for (const Vec2& q : p) out.at.push_back(map({q.x, q.y, bend * std::sin(q.x) * std::cos(0.7 * q.y)}));
    return out;
}

std::string written(const std::vector<Vec3>& p, const std::string& format, const std::string& end) {
    std::ostringstream out;
    out.precision(17);
    std::string face = std::to_string(p.size());
    if (format == "off") out << "OFF" << p.size() << " 1 0" << end;
    if (format == "ply")
        out << "ply" << end << "format ascii 1.0" << end << "element vertex " << p.size() << end << "property double x"
            << end << "property double y" << end << "property double z" << end << "element face 1" << end
            << "property list uchar int vertex_indices" << end << "end_header" << end;
    for (const Vec3& v : p) out << (format == "obj" ? "v " : "") << v.x << ' ' << v.y << ' ' << v.z << end;
    if (format == "obj") face = "f";
    for (std::size_t i = 0; i < p.size(); ++i) face += " " + std::to_string(format == "obj" ? i + 1 : i);
    out << face << end;
    return out.str();
}

double area(const mesh::Mesh& m) {
    double out = 0;
    for (const auto& t : m.triangles)
        out += norm(cross(m.vertices[t[1]] - m.vertices[t[0]], m.vertices[t[2]] - m.vertices[t[0]])) / 2;
    return out;
}

template <class Shape>
void try_shape(const char* name, const Shape& shape) {
    for (std::uint32_t seed = 0; seed < trials(); ++seed) {
        std::mt19937 chance(seed);
        const std::vector<Vec2> flat = shape(chance);
        const double bend = seed % 2 == 0 ? 0 : 0.02;
        const Posed p = posed(flat, chance, bend);
        const char* formats[] = {"obj", "off", "ply"};
        const char* ends[] = {"\n", "\r\n", "\r"};
        const std::string text = written(p.at, formats[seed % 3], ends[seed / 3 % 3]);
        const mesh::File file = mesh::read(text, "it");
        EXPECT_TRUE(file.notes.empty()) << name << ' ' << seed;
        EXPECT_EQ(file.mesh.triangles.size(), p.at.size() - 2) << name << ' ' << seed;
        EXPECT_NEAR(area(file.mesh), area(flat), 1e-9 + bend * area(flat)) << name << ' ' << seed;
    }
}

} // namespace polygons

TEST(Polygons, OfManyShapesHaveTheirAreaInEveryFormat) {
    polygons::try_shape("star", polygons::star);
    polygons::try_shape("stairs", polygons::stairs);
    polygons::try_shape("keyhole", polygons::keyhole);
}

TEST(Polygons, AConvexOneIsAFanFromItsFirstCorner) {
    mesh::Faces faces;
    const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0.1}, {0, 2, 0}};
    faces.add(std::vector<std::uint32_t>{0, 1, 2, 3});
    Notes notes;
    faces.cut(square, notes);
    EXPECT_EQ(faces.triangles, (std::vector<mesh::Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygons, OneThatCrossesItselfIsNoted) {
    mesh::Faces faces;
    const std::vector<Vec3> bow{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}, {-1, 1, 0}};
    faces.add(std::vector<std::uint32_t>{0, 1, 2, 3, 4});
    Notes notes;
    faces.cut(bow, notes);
    EXPECT_EQ(faces.triangles.size(), 3U);
    ASSERT_EQ(notes.size(), 1U);
}

// A tooth thinner than it is bent: seen along the mean normal, its base lies beyond its other side, and the last
// triangle would fold over in silence.
TEST(Polygons, ATriangleThatWouldFoldOverIsNoted) {
    mesh::Faces faces;
    const std::vector<Vec3> tooth{{0, 0, 0}, {6, 0, 0}, {6, 18, 0}, {5.9, 18, 0}, {6.1, 1, 0}, {0, 1, 0}};
    faces.add(std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    Notes notes;
    faces.cut(tooth, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::face_crosses_itself);
}

// A wheel of 90,000 teeth takes a moment; by a scan of all corners for each it would take an hour.
TEST(Polygons, ManyCornersTakeNoSquareOfTime) {
    constexpr int kTeeth = 45000;
    std::vector<Vec3> wheel;
    std::vector<std::uint32_t> corners;
    for (int i = 0; i < 2 * kTeeth; ++i) {
        const double angle = std::numbers::pi * i / kTeeth, far = i % 2 == 0 ? 5 : 10;
        corners.push_back(static_cast<std::uint32_t>(wheel.size()));
        wheel.push_back({far * std::cos(angle), far * std::sin(angle), 0});
    }
    mesh::Faces faces;
    faces.add(corners);
    Notes notes;
    faces.cut(wheel, notes);
    EXPECT_TRUE(notes.empty());
    mesh::Mesh m{wheel, faces.triangles};
    EXPECT_NEAR(polygons::area(m), kTeeth * 50 * std::sin(std::numbers::pi / kTeeth), 1e-6);
}
