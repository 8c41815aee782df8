#include "mesh/step/step.hpp"

#include "base/error.hpp"
#include "mesh/place.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace {

using namespace filum;
using geom::Vec3;

mesh::File read(const std::string& path, const mesh::step::Tessellation& how = {}) {
    const mesh::Bytes bytes = mesh::load(path);
    return mesh::step::read(bytes.view(), mesh::spoken_name(path), how);
}

const std::string kHere = std::string(FILUM_EXAMPLES) + "/../tests/lib/mesh/step/";
const std::string kBracket = std::string(FILUM_EXAMPLES) + "/bracket/bracket.step";

// Every side of a triangle is one of another the other way, and of no third.
bool closed_manifold(const mesh::Mesh& m) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& t : m.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
    return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
        const auto back = sides.find({side.first.second, side.first.first});
        return side.second == 1 && back != sides.end() && back->second == 1;
    });
}

std::vector<double> area_of_faces(const mesh::Mesh& m) {
    std::vector<double> out;
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const auto& [a, b, c] = m.triangles[t];
        if (out.size() < m.faces[t]) out.resize(m.faces[t]);
        out[m.faces[t] - 1] += norm(cross(m.vertices[b] - m.vertices[a], m.vertices[c] - m.vertices[a])) / 2;
    }
    return out;
}

std::string error_of(const std::string& bytes, Exit exit) {
    try {
        mesh::step::read(bytes, "'it'");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), exit) << e.what();
        return e.what();
    }
    ADD_FAILURE() << "read";
    return "";
}

class Step : public ::testing::Test {
    void SetUp() override {
        if (!mesh::step::available()) GTEST_SKIP() << "no OpenCASCADE in this build; scripts/setup --step";
    }
};

TEST_F(Step, BracketIsClosedWithItsThirteenFacesAndItsVolume) {
    const auto file = read(kBracket);
    EXPECT_TRUE(file.notes.empty());
    EXPECT_TRUE(closed_manifold(file.mesh));
    ASSERT_EQ(file.mesh.faces.size(), file.mesh.triangles.size());
    EXPECT_EQ(std::set<std::uint32_t>(file.mesh.faces.begin(), file.mesh.faces.end()).size(), 13U);
    EXPECT_EQ(*std::max_element(file.mesh.faces.begin(), file.mesh.faces.end()), 13U);
    EXPECT_NEAR(mesh::volume(file.mesh), 69023, 69);
}

TEST_F(Step, SameTrianglesAgain) {
    const auto one = read(kBracket), two = read(kBracket);
    EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
    EXPECT_EQ(one.mesh.faces, two.mesh.faces);
    for (std::size_t v = 0; v < one.mesh.vertices.size(); ++v)
        ASSERT_EQ(distance(one.mesh.vertices[v], two.mesh.vertices[v]), 0);
}

TEST_F(Step, SphereWithPolesAndSeamIsClosedAndWithinTheDeflection) {
    for (const double deflection : {0.02, 0.1}) {
        const auto m = read(kHere + "sphere.step", {deflection, 90}).mesh;
        const Vec3 centre{1, 2, 3};
        EXPECT_TRUE(closed_manifold(m));
        for (const auto& v : m.vertices) ASSERT_NEAR(distance(v, centre), 10, 1e-6);
        double worst = 0;
        for (const auto& [a, b, c] : m.triangles)
            worst = std::max(worst, 10 - distance(1.0 / 3 * (m.vertices[a] + m.vertices[b] + m.vertices[c]), centre));
        EXPECT_LT(worst, 1.5 * deflection);
        EXPECT_GT(worst, deflection / 20);
        EXPECT_GT(mesh::volume(m), 0);
        EXPECT_NEAR(mesh::volume(m) / (4.0 / 3 * M_PI * 1000), 1, 3 * deflection / 10);
    }
}

TEST_F(Step, AngleBindsWhereDeflectionDoesNot) {
    const auto coarse = read(kHere + "sphere.step", {5, 45}).mesh, fine = read(kHere + "sphere.step", {5, 5}).mesh;
    EXPECT_GT(fine.triangles.size(), 10 * coarse.triangles.size());
}

// Two cylinders of radius 5 mm and 20 mm high, the second laid down and moved, and a cone; written in inches.
TEST_F(Step, AssemblyInInchesComesInMillimetresEachBodyInItsPlace) {
    const auto m = read(kHere + "inches.step", {0.001, 5}).mesh;
    EXPECT_TRUE(closed_manifold(m));
    EXPECT_EQ(mesh::shells_of(m).count, 3U);
    const auto area = area_of_faces(m);
    ASSERT_EQ(area.size(), 8U);
    for (const std::size_t first : {0U, 3U}) {
        EXPECT_NEAR(area[first], 2 * M_PI * 5 * 20, 0.4);
        EXPECT_NEAR(area[first + 1], M_PI * 25, 0.1);
        EXPECT_NEAR(area[first + 2], M_PI * 25, 0.1);
    }
    EXPECT_NEAR(area[6], M_PI * 6 * std::hypot(6, 9), 0.2);
    EXPECT_NEAR(mesh::volume(m), 2 * M_PI * 25 * 20 + M_PI * 36 * 9 / 3, 3);
    const auto box = mesh::bounds(m);
    EXPECT_NEAR(box.lo.y, -20, 1e-6);
    EXPECT_NEAR(box.hi.x, 66, 1e-6);
}

TEST_F(Step, FacesWrittenApartAreJoined) {
    const auto m = read(kHere + "loose.step").mesh;
    EXPECT_TRUE(closed_manifold(m));
    EXPECT_EQ(m.vertices.size(), 8U);
    EXPECT_NEAR(std::abs(mesh::volume(m)), 480, 1e-9);
    auto area = area_of_faces(m);
    std::sort(area.begin(), area.end());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(area[i], std::vector<double>({48, 48, 60, 60, 80, 80})[i], 1e-9);
}

TEST_F(Step, DamagedFilesAreErrors) {
    const std::string all(mesh::load(kHere + "sphere.step").view()), end = "\nENDSEC;\nEND-ISO-10303-21;\n";
    EXPECT_NE(error_of(all.substr(0, 1500), Exit::truncated).find("ends before"), std::string::npos);
    EXPECT_NE(error_of("ISO-10303-21;" + end, Exit::bad_input).find("STEP"), std::string::npos);
    EXPECT_NE(error_of(all.substr(0, all.find("#15")) + end, Exit::bad_input).find("cannot read 'it'"),
              std::string::npos);
    std::string broken = all;
    for (std::size_t at = 800; at < broken.size() - 60; at += 17) broken[at] = '#';
    EXPECT_NE(error_of(broken, Exit::bad_input).find("cannot read 'it'"), std::string::npos);
}

TEST_F(Step, AFaceThatCannotBeReadIsNoted) {
    std::string text(mesh::load(kHere + "loose.step").view());
    text.replace(text.find("PLANE("), 6, "PLANT(");
    const auto file = mesh::step::read(text, "'it'");
    ASSERT_EQ(file.notes.size(), 1U);
    EXPECT_EQ(file.notes[0].code, NoteCode::cad_face_unread);
    EXPECT_EQ(file.notes[0].count, 1U);
    EXPECT_EQ(area_of_faces(file.mesh).size(), 5U);
}

TEST(StepOrNot, OtherMeshesAreReadAsEver) {
    const auto file = read(std::string(FILUM_EXAMPLES) + "/bar/bar.stl");
    EXPECT_EQ(file.kind, mesh::Kind::stl_binary);
    EXPECT_EQ(file.mesh.triangles.size(), 12U);
    EXPECT_TRUE(file.mesh.faces.empty());
}

TEST(StepOrNot, IsKnownByItsFirstWord) {
    EXPECT_EQ(mesh::recognise("ISO-10303-21;\nHEADER;"), mesh::Kind::step);
    EXPECT_EQ(mesh::recognise("\n ISO-10303-21;\n"), mesh::Kind::step);
    EXPECT_THROW(mesh::read("ISO-10303-21;\nHEADER;", "'it'"), Error);
}

} // namespace
