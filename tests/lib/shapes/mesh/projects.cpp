// What slicers' projects hold beside the part: bodies with settings, and painted faces.
#include "mesh/paint.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace filum::mesh {
namespace {

using Purpose = Body::Purpose;

std::string metadata(const std::string& key, const std::string& value) {
    return "<metadata type=\"volume\" key=\"" + key + "\" value=\"" + value + "\"/>";
}

double area(const Corners& c) { return geom::norm(cross(c[1] - c[0], c[2] - c[0])) / 2; }

// A random painted triangle as slicers write it, last digit first, and how much of it has which paint.
struct Random {
    std::mt19937 random;
    std::string digits;
    std::map<int, double> share{};

    void triangle(double part, int depth) {
        const int cut = depth < 5 ? static_cast<int>(random() % 4) : 0;
        constexpr char kHex[] = "0123456789ABCDEF";
        if (cut == 0) {
            const int paint = static_cast<int>(random() % 5);
            share[std::min(paint, 3)] += part;
            digits = std::string(1, kHex[4 * std::min(paint, 3)]) + digits;
            if (paint >= 3) digits = std::string(1, kHex[paint - 3]) + digits;
            return;
        }
        digits = std::string(1, kHex[4 * (random() % 3) + static_cast<unsigned>(cut)]) + digits;
        const std::vector<double> parts = cut == 1   ? std::vector{0.5, 0.5}
                                          : cut == 2 ? std::vector{0.5, 0.25, 0.25} // the last one first
                                                     : std::vector{0.25, 0.25, 0.25, 0.25};
        for (const double p : parts) triangle(p * part, depth + 1);
    }
};

} // namespace

TEST(Projects, PrusaSlicersModifiersKeepTheirSettings) {
    Mesh both = shapes::box({0, 0, 0}, {10, 10, 10});
    const Mesh body = shapes::box({2, 2, 2}, {5, 5, 15});
    for (const auto& t : body.triangles) both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    both.vertices.insert(both.vertices.end(), body.vertices.begin(), body.vertices.end());
    const std::string config = "<config><object id=\"1\"><volume firstid=\"12\" lastid=\"23\">" +
                               metadata("name", "knob") + metadata("volume_type", "ParameterModifier") +
                               metadata("matrix", "1 0 0 0") + metadata("source_file", "knob.stl") +
                               metadata("fill_density", "40%") + metadata("perimeters", "1") +
                               "</volume></object></config>";
    const File f =
        read(shapes::archive("<model unit=\"centimeter\"><resources><object id=\"1\">" + shapes::model_mesh(both) +
                                 "</object></resources><build><item objectid=\"1\" transform=\"1 0 0 0 1 0 "
                                 "0 0 1 7 0 0\"/></build></model>",
                             {{"Metadata/Slic3r_PE_model.config", config}}),
             "it");
    ASSERT_EQ(f.bodies.size(), 1U);
    EXPECT_EQ(f.bodies[0].what, Purpose::modifier);
    const std::vector<std::pair<std::string, std::string>> settings{{"fill_density", "40%"}, {"perimeters", "1"}};
    EXPECT_EQ(f.bodies[0].settings, settings);
    EXPECT_NEAR(volume(f.bodies[0].mesh), 117e3, 1e-6);
    EXPECT_EQ(f.bodies[0].mesh.vertices.size(), 8U);
    EXPECT_NEAR(bounds(f.bodies[0].mesh).lo.x, 90, 1e-9);
    EXPECT_NEAR(volume(f.mesh), 1e6, 1e-6);
}

TEST(Projects, BambuStudiosModifiersLieWhereTheirComponentsDo) {
    const std::string model =
        "<model><resources><object id=\"1\">" + shapes::model_mesh(shapes::box({0, 0, 0}, {10, 10, 10})) +
        "</object><object id=\"2\" type=\"other\">" + shapes::model_mesh(shapes::box({0, 0, 0}, {3, 3, 3})) +
        "</object><object id=\"3\"><components><component objectid=\"1\"/><component objectid=\"2\" transform=\"1 0 0 "
        "0 1 0 0 0 1 4 5 6\"/></components></object></resources><build><item objectid=\"3\"/></build></model>";
    for (const auto& [subtype, what] : {std::pair{"modifier_part", Purpose::modifier},
                                        {"support_enforcer", Purpose::enforcer},
                                        {"support_blocker", Purpose::blocker},
                                        {"negative_part", Purpose::negative}}) {
        const std::string config = "<config><object id=\"3\"><part id=\"1\" subtype=\"normal_part\"/><part id=\"2\" "
                                   "subtype=\"" +
                                   std::string(subtype) + "\">" + metadata("wall_loops", "4") +
                                   "</part></object></config>";
        const File f = read(shapes::archive(model, {{"Metadata/model_settings.config", config}}), "it");
        ASSERT_EQ(f.bodies.size(), 1U);
        EXPECT_EQ(f.bodies[0].what, what);
        EXPECT_EQ(f.bodies[0].settings.at(0).first, "wall_loops");
        EXPECT_NEAR(volume(f.bodies[0].mesh), 27, 1e-9);
        EXPECT_NEAR(bounds(f.bodies[0].mesh).lo.z, 6, 1e-9);
        EXPECT_NEAR(volume(f.mesh), 1000, 1e-9);
    }
}

TEST(Projects, PaintedFacesAreBodiesOfTheirOwn) {
    const auto painted = [](const std::string& name, const std::string& value) {
        std::string mesh = shapes::model_mesh(shapes::box({0, 0, 0}, {10, 10, 10}));
        mesh.replace(mesh.find("<triangle "), 10, "<triangle " + name + "=\"" + value + "\" ");
        return read(shapes::archive("<model><resources><object id=\"1\">" + mesh +
                                    "</object></resources><build><item objectid=\"1\"/></build></model>"),
                    "it");
    };
    for (const char* name : {"slic3rpe:custom_supports", "paint_supports"}) {
        const File wanted = painted(name, "4"), unwanted = painted(name, "8"), half = painted(name, "041");
        ASSERT_EQ(wanted.bodies.size(), 1U);
        EXPECT_EQ(wanted.bodies[0].what, Purpose::painted);
        EXPECT_EQ(wanted.bodies[0].mesh.triangles.size(), 1U);
        ASSERT_EQ(unwanted.bodies.size(), 1U);
        EXPECT_EQ(unwanted.bodies[0].what, Purpose::painted_blocker);
        ASSERT_EQ(half.bodies.size(), 1U);
        const auto& m = half.bodies[0].mesh;
        EXPECT_NEAR(area({m.vertices[0], m.vertices[1], m.vertices[2]}), 25, 1e-9);
        for (const char* damaged : {"x", "1", "44", "3"}) {
            const File f = painted(name, damaged);
            ASSERT_EQ(f.notes.size(), 1U) << damaged;
            EXPECT_EQ(f.notes[0].code, NoteCode::paint_unreadable);
        }
    }
    for (const char* name : {"slic3rpe:custom_seam", "paint_seam"})
        for (const auto& [value, what] : {std::pair{"4", Purpose::painted_seam}, {"8", Purpose::painted_no_seam}}) {
            const File f = painted(name, value);
            ASSERT_EQ(f.bodies.size(), 1U);
            EXPECT_EQ(f.bodies[0].what, what);
            EXPECT_EQ(f.bodies[0].mesh.triangles.size(), 1U);
        }
    EXPECT_TRUE(painted("paint_color", "4").bodies.empty());
}

TEST(Projects, PaintOfCutTrianglesIsFound) {
    const Corners whole{geom::Vec3{0, 0, 0}, {7, 1, 2}, {3, 6, -1}};
    const geom::Vec3 up = cross(whole[1] - whole[0], whole[2] - whole[0]);
    for (unsigned seed = 0; seed < 200; ++seed) {
        Random r{std::mt19937(seed), ""};
        r.triangle(1, 0);
        std::map<int, double> found;
        EXPECT_TRUE(each_painted(r.digits, whole, [&](Paint p, const Corners& c) {
            found[static_cast<int>(p)] += area(c) / area(whole);
            EXPECT_GT(dot(cross(c[1] - c[0], c[2] - c[0]), up), 0);
        })) << r.digits;
        for (int paint = 0; paint < 4; ++paint) EXPECT_NEAR(found[paint], r.share[paint], 1e-9) << r.digits;
    }
    // three halves of a side, and of that the one at the told corner: PrusaSlicer writes the last part first
    std::vector<Corners> wanted;
    EXPECT_TRUE(each_painted("40001", whole, [&](Paint, const Corners&) {}) == false);
    EXPECT_TRUE(each_painted("4003", whole, [&](Paint, const Corners&) {}) == false);
    EXPECT_TRUE(each_painted("40003", whole, [&](Paint p, const Corners& c) {
        if (p == Paint::wanted) wanted.push_back(c);
    }));
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0][0], whole[0]);
}

} // namespace filum::mesh
