// What the 3MF standard says of extensions, kinds of objects and plates, and how items stand on the bed.
#include "base/error.hpp"
#include "mesh/place.hpp"
#include "mesh/read.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::mesh {
namespace {

using Purpose = Body::Purpose;

const std::string kBase = "http://schemas.microsoft.com/3dmanufacturing/";

std::string box_object(int id, const std::string& attributes = "", Vec3 lo = {0, 0, 0}, Vec3 hi = {10, 10, 10}) {
    return "<object id=\"" + std::to_string(id) + "\" " + attributes + ">" + shapes::model_mesh(shapes::box(lo, hi)) +
           "</object>";
}

std::string item(int id, Vec3 to = {}) {
    return "<item objectid=\"" + std::to_string(id) + "\" transform=\"1 0 0 0 1 0 0 0 1 " + std::to_string(to.x) + " " +
           std::to_string(to.y) + " " + std::to_string(to.z) + "\"/>";
}

std::string model(const std::string& objects, const std::string& items, const std::string& attributes = "") {
    return "<model " + attributes + "><resources>" + objects + "</resources><build>" + items + "</build></model>";
}

// What an archive with that model cannot be read for; "" if it can.
std::string refusal(const std::string& text, const std::map<std::string, std::string>& others = {}, int plate = 1) {
    try {
        read(shapes::archive(text, others), "it", plate);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

bool mentions(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

} // namespace

TEST(ThreeMfRules, RequiredExtensionsAreKnownOrNamed) {
    const auto required = [](const std::string& prefixes, const std::string& declared) {
        return refusal(model(box_object(1), item(1), declared + " requiredextensions=\"" + prefixes + "\""));
    };
    for (const std::string known : {"production/2015/06", "material/2015/02", "trianglesets/2021/07", "slice/2015/07"})
        EXPECT_EQ(required("x", "xmlns:x=\"" + kBase + known + "\""), "") << known;
    for (const std::string name : {"beamlattice", "volumetric", "securecontent", "implicit", "displacement"})
        EXPECT_TRUE(mentions(required("x", "xmlns:x=\"" + kBase + name + "/2017/02\""), "'" + name + "'")) << name;
    EXPECT_TRUE(mentions(required("a b", "xmlns:a=\"" + kBase + "production/2015/06\" xmlns:b=\"http://me/1\""),
                         "'http://me/1'"));
    EXPECT_TRUE(mentions(required("undeclared", ""), "'undeclared'"));
    EXPECT_EQ(required("", ""), "");
}

TEST(ThreeMfRules, ShapesOfExtensionsAreNotedOrRefused) {
    std::string lattice = box_object(1);
    lattice.insert(lattice.find("</mesh>"), "<b:beamlattice/>");
    const File f = read(shapes::archive(model(lattice, item(1))), "it");
    ASSERT_EQ(f.notes.size(), 1U);
    EXPECT_TRUE(mentions(f.notes[0].detail, "beamlattice"));
    EXPECT_TRUE(mentions(refusal(model("<object id=\"1\"><bo:booleanshape/></object>", item(1))), "booleanshape"));
    EXPECT_TRUE(mentions(refusal(model(box_object(1, "s:meshresolution=\"lowres\""), item(1))), "slice"));
}

TEST(ThreeMfRules, TypesOfObjectsDoWhatTheStandardSays) {
    for (const std::string type : {"support", "solidsupport", "surface"}) {
        const std::string other = box_object(2, "type=\"" + type + "\"", {20, 0, 0}, {22, 2, 2});
        const File f = read(shapes::archive(model(box_object(1) + other, item(1) + item(2))), "it");
        EXPECT_EQ(f.mesh.triangles.size(), 12U) << type;
        ASSERT_EQ(f.notes.size(), 1U) << type;
        EXPECT_EQ(f.notes[0].count, 1U);
        // as a component of a part, too
        const std::string group = "<object id=\"3\"><components><component objectid=\"1\"/><component "
                                  "objectid=\"2\"/></components></object>";
        EXPECT_EQ(read(shapes::archive(model(box_object(1) + other + group, item(3))), "it").mesh.triangles.size(),
                  12U);
        EXPECT_NE(refusal(model(other, item(2))), "") << type;
    }
    EXPECT_TRUE(mentions(refusal(model(box_object(1, "type=\"other\""), item(1))), "other"));
    EXPECT_TRUE(mentions(refusal(model(box_object(1, "type=\"odd\""), item(1))), "odd"));
    EXPECT_EQ(refusal(model(box_object(1) + box_object(2, "type=\"other\""), item(1))), ""); // nobody asks for it
}

TEST(ThreeMfRules, WhatIsNotOneModelIsRefused) {
    EXPECT_NE(refusal(model(box_object(1) + box_object(1), item(1))), "");
    EXPECT_NE(refusal(model(box_object(1), item(1)) + model(box_object(1), item(1))), "");
    EXPECT_NE(refusal("<!DOCTYPE x [<!ENTITY a \"b\">]>" + model(box_object(1), item(1))), "");
    EXPECT_NE(refusal("<model><resources>" + box_object(1) + "</resources></model>"), "");
    EXPECT_NE(refusal(model(box_object(1), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/>")), "");
}

// A number that is followed by something else was cut there in silence: "10,5" was 10.
TEST(ThreeMfRules, NumbersAreReadWholeOrNamed) {
    for (const std::string number : {"10,5", "10.5.1", "1e", "10 5", "ten", "0x10", "10mm"}) {
        std::string box = box_object(1);
        const auto at = box.find("x=\"10");
        box.replace(at, box.find('"', at + 3) - at, "x=\"" + number);
        EXPECT_TRUE(mentions(refusal(model(box, item(1))), "'" + number + "' is no number")) << number;
    }
    for (const std::string place : {"1 0 0 0 1 0 0 0 1 0 0", "1 0 0 0 1 0 0 0 1 0 0 0 1", "1 0 0 0 1 0 0 0 1 0 0 0,5",
                                    "nan 0 0 0 1 0 0 0 1 0 0 0", "1 0 0 0 1 0 0 0 1 inf 0 0"})
        EXPECT_TRUE(mentions(refusal(model(box_object(1), "<item objectid=\"1\" transform=\"" + place + "\"/>")),
                             "twelve numbers"))
            << place;
    std::string box = box_object(1);
    box.insert(box.find("v1=\"0") + 5, "0.");
    EXPECT_TRUE(mentions(refusal(model(box, item(1))), "no vertex"));
    const auto group = [](int id, int of) {
        return "<object id=\"" + std::to_string(id) + "\"><components><component objectid=\"" + std::to_string(of) +
               "\"/></components></object>";
    };
    EXPECT_TRUE(mentions(refusal(model(group(1, 2) + group(2, 1), item(1))), "circle"));
}

// Random plates: of each plate exactly its instances are read, the others are named.
TEST(ThreeMfRules, PlatesAreReadOneAtATime) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 50; ++trial) {
        const int plates = 1 + static_cast<int>(random() % 4), objects = 1 + static_cast<int>(random() % 3);
        std::string items, config = "<config>";
        std::vector<std::string> on(static_cast<std::size_t>(plates));
        std::vector<std::vector<double>> at(static_cast<std::size_t>(plates));
        std::map<int, int> instances;
        for (int k = 0; k < 6; ++k) {
            const int object = 1 + static_cast<int>(random() % static_cast<unsigned>(objects));
            const auto plate = random() % static_cast<unsigned>(plates + 1); // the last one: on none
            const double x = 20.0 * k;
            items += item(object, {x, 0, 0});
            const int instance = instances[object]++;
            if (plate == static_cast<unsigned>(plates)) continue;
            on[plate] += "<model_instance><metadata key=\"object_id\" value=\"" + std::to_string(object) +
                         "\"/><metadata key=\"instance_id\" value=\"" + std::to_string(instance) +
                         "\"/></model_instance>";
            at[plate].push_back(x);
        }
        std::size_t all = 0;
        for (std::size_t p = 0; p < on.size(); ++p) {
            config +=
                "<plate><metadata key=\"plater_id\" value=\"" + std::to_string(p + 1) + "\"/>" + on[p] + "</plate>";
            all += at[p].size();
        }
        if (all == 0) continue;
        std::string boxes;
        for (int k = 1; k <= objects; ++k) boxes += box_object(k);
        const std::string text = model(boxes, items);
        const std::map<std::string, std::string> others{{"Metadata/model_settings.config", config + "</config>"}};
        for (std::size_t p = 0; p < on.size(); ++p) {
            const int number = static_cast<int>(p) + 1;
            if (at[p].empty()) {
                EXPECT_NE(refusal(text, others, number), "");
                continue;
            }
            const File f = read(shapes::archive(text, others), "it", number);
            EXPECT_EQ(f.mesh.triangles.size(), 12 * at[p].size());
            EXPECT_NEAR(bounds(f.mesh).lo.x, at[p].front(), 1e-9);
            EXPECT_NEAR(bounds(f.mesh).hi.x, at[p].back() + 10, 1e-9);
            std::size_t told = 0;
            for (const Note& n : f.notes) told += n.count;
            EXPECT_EQ(told, 6 - at[p].size());
        }
        EXPECT_NE(refusal(text, others, plates + 1), "");
    }
    EXPECT_NE(refusal(model(box_object(1), item(1)), {}, 2), ""); // without plates there is one
}

TEST(ThreeMfRules, ItemsStandOnTheBed) {
    const auto low = [](const File& f, double x) { // of what is right of x
        double out = 1e9;
        for (const Vec3& v : f.mesh.vertices)
            if (v.x >= x) out = std::min(out, v.z);
        return out;
    };
    // apart: each is set down; one over the other: an assembly
    const File apart = read(shapes::archive(model(box_object(1), item(1, {0, 0, -3}) + item(1, {30, 0, 2}))), "it");
    EXPECT_NEAR(low(apart, -1), 0, 1e-9);
    EXPECT_NEAR(low(apart, 29), 0, 1e-9);
    ASSERT_EQ(apart.notes.size(), 1U);
    EXPECT_NEAR(apart.notes[0].amount, 3, 1e-9);
    EXPECT_EQ(apart.notes[0].count, 2U);
    const File over = read(shapes::archive(model(box_object(1), item(1, {0, 0, -3}) + item(1, {5, 0, 7}))), "it");
    EXPECT_NEAR(low(over, -1), -3, 1e-9);
    EXPECT_NEAR(bounds(over.mesh).hi.z, 17, 1e-9);
    EXPECT_TRUE(over.notes.empty());
    // of a slicer's project what is below the bed is cut away
    const File sunk = read(shapes::archive(model(box_object(1), item(1, {0, 0, -3}) + item(1, {30, 0, 0})),
                                           {{"Metadata/Slic3r_PE.config", "; layer_height = 0.2"}}),
                           "it");
    ASSERT_EQ(sunk.bodies.size(), 1U);
    EXPECT_EQ(sunk.bodies[0].what, Purpose::negative);
    EXPECT_NEAR(bounds(sunk.bodies[0].mesh).hi.z, 0, 1e-9);
    ASSERT_EQ(sunk.items.size(), 24U);
    EXPECT_EQ(sunk.items[0], sunk.bodies[0].item);
    EXPECT_NE(sunk.items[12], sunk.bodies[0].item);
}

TEST(ThreeMfRules, EachInstanceHasItsOwnNegativeBodies) {
    Mesh both = shapes::box({0, 0, 0}, {10, 10, 10});
    const Mesh body = shapes::box({2, 2, 2}, {5, 5, 15});
    for (const auto& t : body.triangles) both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    both.vertices.insert(both.vertices.end(), body.vertices.begin(), body.vertices.end());
    const File f =
        read(shapes::archive(
                 model("<object id=\"1\">" + shapes::model_mesh(both) + "</object>", item(1) + item(1, {20, 0, 0})),
                 {{"Metadata/Slic3r_PE_model.config",
                   "<config><object id=\"1\"><volume firstid=\"12\" lastid=\"23\"><metadata "
                   "key=\"volume_type\" value=\"NegativeVolume\"/></volume></object></config>"}}),
             "it");
    ASSERT_EQ(f.bodies.size(), 2U);
    EXPECT_EQ(f.bodies[0].item, 0U);
    EXPECT_EQ(f.bodies[1].item, 1U);
    EXPECT_NEAR(bounds(f.bodies[1].mesh).lo.x, 22, 1e-9);
    ASSERT_EQ(f.items.size(), 24U);
    EXPECT_EQ(f.items[11], 0U);
    EXPECT_EQ(f.items[12], 1U);
}

// A program that a printer takes in a 3MF archive is no part.
TEST(ThreeMfRules, ProgramsAreNamed) {
    const std::string empty = "<model><resources/><build/></model>";
    try {
        read(shapes::archive(empty, {{"Metadata/plate_1.gcode", "G28"}}), "it");
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        EXPECT_NE(std::string(e.what()).find("it holds a program for a printer"), std::string::npos) << e.what();
    }
}

} // namespace filum::mesh
