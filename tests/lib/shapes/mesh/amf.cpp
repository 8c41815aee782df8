// AMF files: units, places, materials, and what slicers write in them.
#include "shapes.hpp"

#include "base/error.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"

#include <gtest/gtest.h>

namespace filum::mesh {
namespace {

const Mesh kBox = shapes::box({0, 0, 0}, {1, 2, 3});

std::string amf_metadata(const std::string& type, const std::string& value) {
    return "<metadata type=\"" + type + "\">" + value + "</metadata>";
}

std::string amf_instance(const std::string& id, const std::string& content) {
    return "<instance objectid=\"" + id + "\">" + content + "</instance>";
}

geom::Box3 amf_box(const Mesh& m) {
    geom::Box3 out;
    for (const Vec3& v : m.vertices) out.add(v);
    return out;
}

void expect_box(const Mesh& m, const Vec3& lo, const Vec3& hi) {
    const geom::Box3 box = amf_box(m);
    EXPECT_LT(distance(box.lo, lo), 1e-9);
    EXPECT_LT(distance(box.hi, hi), 1e-9);
}

std::string amf_refusal(const std::string& text) {
    try {
        read(text, "it");
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

TEST(Amf, UnitsAreConverted) {
    for (const auto& [unit, mm] : {std::pair{"", 1.0},
                                   {" unit=\"millimeter\"", 1.0},
                                   {" unit=\"inch\"", 25.4},
                                   {" unit=\"feet\"", 304.8},
                                   {" unit=\"meter\"", 1000.0},
                                   {" unit=\"micron\"", 0.001}}) {
        const File f = read(shapes::amf(shapes::amf_object(kBox, "1"), unit), "it");
        EXPECT_EQ(f.kind, Kind::amf);
        expect_box(f.mesh, {}, mm * Vec3{1, 2, 3});
    }
    EXPECT_NE(amf_refusal(shapes::amf(shapes::amf_object(kBox, "1"), " unit=\"cubit\"")).find("'cubit'"),
              std::string::npos);
}

TEST(Amf, ConstellationsPlaceObjects) {
    const std::string box = shapes::amf_object(kBox, "1");
    const auto placed = [&](const std::string& how) {
        return read(shapes::amf(box + "<constellation id=\"9\">" + amf_instance("1", how) + "</constellation>"), "it")
            .mesh;
    };
    expect_box(placed("<deltax>10</deltax><deltaz>-1</deltaz>"), {10, 0, -1}, {11, 2, 2});
    expect_box(placed("<rz>90</rz>"), {-2, 0, 0}, {0, 1, 3});
    expect_box(placed("<rx>90</rx>"), {0, -3, 0}, {1, 0, 2});
    expect_box(placed("<ry>90</ry>"), {0, 0, -1}, {3, 2, 0});
    expect_box(placed("<rx>90</rx><rz>90</rz><deltay>5</deltay>"), {0, 5, 0}, {3, 6, 2}); // x before z
    expect_box(placed("<scale>2</scale>"), {}, {2, 4, 6});
    const Mesh mirrored = placed("<mirrorx>1</mirrorx><scalez>2</scalez>");
    expect_box(mirrored, {-1, 0, 0}, {0, 2, 6});
    EXPECT_NEAR(volume(mirrored), 12, 1e-9); // it faces outwards
    // An object and a constellation may have the same id, as in files of FreeCAD.
    const std::string same = "<constellation id=\"1\">" + amf_instance("1", "<deltax>3</deltax>") + "</constellation>";
    expect_box(read(shapes::amf(box + same), "it").mesh, {3, 0, 0}, {4, 2, 3});
    // A constellation of constellations, and an object that none places.
    const File several =
        read(shapes::amf(box + shapes::amf_object(shapes::box({50, 0, 0}, {51, 1, 1}), "2") +
                         "<constellation id=\"9\">" + amf_instance("1", "") + amf_instance("1", "<deltax>5</deltax>") +
                         "</constellation><constellation id=\"10\">" + amf_instance("9", "<deltay>20</deltay>") +
                         "</constellation>"),
             "it");
    EXPECT_EQ(several.mesh.triangles.size(), 36U);
    expect_box(several.mesh, {0, 0, 0}, {51, 22, 3});
}

TEST(Amf, MaterialsAndBodiesOfSlicers) {
    const Mesh other = shapes::box({2, 0, 0}, {3, 1, 1});
    const File two = read(shapes::amf(shapes::amf_object(kBox, "1", " materialid=\"7\"") +
                                      shapes::amf_object(other, "2", " materialid=\"5\"")),
                          "it");
    ASSERT_EQ(two.materials.size(), 24U);
    EXPECT_EQ(two.materials.front(), 0U);
    EXPECT_EQ(two.materials.back(), 1U);
    for (const auto& [mark, what] :
         {std::pair{amf_metadata("slic3r.modifier", "1"), Body::Purpose::modifier},
          {amf_metadata("slic3r.volume_type", "ParameterModifier"), Body::Purpose::modifier},
          {amf_metadata("slic3r.volume_type", "NegativeVolume"), Body::Purpose::negative},
          {amf_metadata("slic3r.volume_type", "SupportBlocker"), Body::Purpose::blocker},
          {amf_metadata("slic3r.volume_type", "SupportEnforcer"), Body::Purpose::enforcer}}) {
        const File f =
            read(shapes::amf(shapes::amf_object(kBox, "1") +
                             shapes::amf_object(other, "2", "", mark + amf_metadata("slic3r.fill_density", "40%"))),
                 "it");
        EXPECT_EQ(f.mesh.triangles.size(), 12U);
        ASSERT_EQ(f.bodies.size(), 1U);
        EXPECT_EQ(f.bodies[0].what, what);
        EXPECT_EQ(f.bodies[0].settings, (std::vector{std::pair<std::string, std::string>{"fill_density", "40%"}}));
        expect_box(f.bodies[0].mesh, {2, 0, 0}, {3, 1, 1});
        EXPECT_EQ(f.items.size(), what == Body::Purpose::negative ? 12U : 0U);
    }
    const File supported =
        read(shapes::amf(shapes::amf_object(kBox, "1") + shapes::amf_object(other, "2", " type=\"support\"")), "it");
    EXPECT_EQ(supported.mesh.triangles.size(), 12U);
    ASSERT_EQ(supported.notes.size(), 1U);
    EXPECT_EQ(supported.notes[0].code, NoteCode::support_object_ignored);
}

TEST(Amf, WhatIsWrongIsRefused) {
    const std::string box = shapes::amf_object(kBox, "1");
    const auto says = [&](const std::string& content, const char* what) {
        EXPECT_NE(amf_refusal(shapes::amf(content)).find(what), std::string::npos)
            << what << amf_refusal(shapes::amf(content));
    };
    const auto group = [](const std::string& content) {
        return "<constellation id=\"9\">" + content + "</constellation>";
    };
    says(box + box, "two objects have the id '1'");
    says(box + group(amf_instance("8", "")), "object '8' is missing");
    says(box + group(amf_instance("9", "") + amf_instance("1", "")), "none of its objects"); // only within itself
    says(box + group(amf_instance("10", "")) + "<constellation id=\"10\">" + amf_instance("9", "") +
             "</constellation>" + "<constellation id=\"11\">" + amf_instance("10", "") + "</constellation>",
         "in a circle");
    says(box + group(amf_instance("1", "<scale>0</scale>")), "flattens");
    says(box + group(amf_instance("1", "<rx>abc</rx>")), "cannot be read");
    says("<object id=\"1\"><mesh><vertices/><volume><triangle><v1>0</v1></triangle></volume></mesh></object>",
         "no vertex");
    says("<object id=\"1\"><mesh><vertices><vertex/></vertices></mesh></object>", "no number 'x'");
    EXPECT_NE(amf_refusal(shapes::amf(box).substr(0, 900)).find("no XML"), std::string::npos);
}

} // namespace
} // namespace filum::mesh
