// Bodies are put where the part was, and cut where it is.
#include "app/modifier/modifier.hpp"

#include "../../../shapes/mesh/archive.cpp" // shapes::archive
#include "../../../shapes/mesh/shapes.hpp"
#include "app/modifier/painted.hpp"
#include "base/error.hpp"
#include "mesh/place.hpp"
#include "polygon/clip.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace filum::app::modifier {
namespace {

// A file that goes with the test.
struct File {
    std::string name =
        (std::filesystem::temp_directory_path() / ("modifier-" + std::to_string(getpid()) + ".stl")).string();
    explicit File(const mesh::Mesh& m) { std::ofstream(name, std::ios::binary) << shapes::stl_binary(m); }
    ~File() { std::remove(name.c_str()); }
};

std::vector<polygon::Region> layers_of(const polygon::Loops& loops, std::uint32_t n) {
    std::vector<polygon::Region> out(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        out[i].id = i;
        out[i].layer = i;
        out[i].height = 0.5;
        out[i].z = 0.5 * (i + 1);
        out[i].loops = loops;
    }
    return out;
}

polygon::Loops test_loops(double lo, double hi) {
    polygon::Loops out;
    out.add(std::vector<geom::Vec2>{{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}});
    return out;
}

stream::Header told(const geom::Affine& map) {
    stream::Header out;
    out.history.push_back({"slice", "1", {placement_setting(map)}, {}});
    out.history.push_back({"regions", "1", {{"bead-width", "0.4"}}, {0}});
    return out;
}

} // namespace

TEST(Modifier, PlacementComesBackAsItWas) {
    const mesh::Mesh box = shapes::box({0, 0, 3}, {1, 2, 4});
    mesh::Mesh moved = box, again = box;
    Notes notes;
    const auto map =
        mesh::place(moved, {.unit = "in", .scale = {1, 0.3, 1}, .rotate_deg = {10, 20, 37}, .center = {100, 50}}, false,
                    notes)
            .map;
    const auto read = placement_in(told(map));
    ASSERT_TRUE(read);
    mesh::move(again, *read);
    for (std::size_t i = 0; i < box.vertices.size(); ++i)
        EXPECT_LT(geom::distance(moved.vertices[i], again.vertices[i]), 1e-9);
    auto two = told(map);
    two.history.push_back(two.history[0]);
    EXPECT_FALSE(placement_in(two)); // unknown to which part the body belongs
    EXPECT_FALSE(placement_in({}));
}

TEST(Modifier, IsCutAtThePartsLayers) {
    const File file(shapes::box({0, 0, 1}, {2, 3, 3}));
    geom::Affine map;
    map.t[0] = 10;
    map.t[2] = -0.5;
    Notes notes;
    const polygon::Loops square = polygon::unite([] {
        polygon::Loops l;
        l.add(std::vector<geom::Vec2>{{8, 0}, {20, 0}, {20, 5}, {8, 5}});
        return l;
    }());
    auto regions = layers_of(square, 8);
    regions.erase(regions.begin() + 2); // an empty layer
    const auto out = body(file.name, told(map), regions, 1, notes).outlines;
    ASSERT_EQ(out.size(), 8U);
    EXPECT_TRUE(notes.empty());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const bool there = i >= 1 && i <= 4 && i != 2; // from z 0.5 to 2.5
        ASSERT_EQ(!out[i].empty(), there) << i;
        if (!there) continue;
        EXPECT_NEAR(polygon::signed_area(out[i]), 6, 1e-6);
        EXPECT_NEAR(polygon::bounds(out[i]).lo.x, 10, 1e-6);
    }
    map.t[0] = 100;
    body(file.name, told(map), regions, 1, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::body_apart);
}

TEST(Modifier, BeyondTenKilometresIsRefused) {
    const File file(shapes::box({0, 0, 1}, {2, 3, 3e7}));
    Notes notes;
    EXPECT_THROW(body(file.name, told({}), layers_of({}, 2), 1, notes), Error);
}

TEST(Modifier, WithoutAPlacementIsRefused) {
    const File file(shapes::box({0, 0, 1}, {2, 3, 3}));
    Notes notes;
    EXPECT_THROW(body(file.name, {}, layers_of({}, 2), 1, notes), Error);
}

// A project: a table of 10 x 10 mm on a leg, in mm, and what it says of faces or bodies.
namespace {

struct Project3mf {
    std::string name;
    Project3mf(const std::string& paint, const std::string& subtype) {
        name = (std::filesystem::temp_directory_path() / ("project-" + std::to_string(getpid()) + subtype + ".3mf"))
                   .string();
        std::string mesh = shapes::model_mesh(shapes::box({0, 0, 2}, {10, 10, 3}));
        if (!paint.empty()) // all of it: only what looks down counts
            for (std::size_t at = mesh.find("<triangle "); at != std::string::npos;
                 at = mesh.find("<triangle ", at + 1))
                mesh.replace(at, 10, "<triangle paint_supports=\"" + paint + "\" ");
        const std::string model =
            "<model><resources><object id=\"1\">" + mesh + "</object><object id=\"2\">" +
            shapes::model_mesh(shapes::box({0, 0, 0}, {4, 4, 4})) +
            "</object><object id=\"3\"><components><component objectid=\"1\"/><component objectid=\"2\"/>"
            "</components></object></resources><build><item objectid=\"3\"/></build></model>";
        const std::string config = "<config><object id=\"3\"><part id=\"2\" subtype=\"" + subtype +
                                   "\"><metadata key=\"wall_loops\" value=\"1\"/></part></object></config>";
        std::ofstream(name, std::ios::binary) << shapes::archive(model, {{"Metadata/model_settings.config", config}});
    }
    ~Project3mf() { std::remove(name.c_str()); }
};

double area_of(const std::vector<polygon::Loops>& outlines, std::size_t layer) {
    return polygon::signed_area(outlines.at(layer));
}

} // namespace

TEST(Modifier, BodiesThatStateTheirUnitAreNotScaledByThePartsUnit) {
    const Project3mf file("", "modifier_part");
    Notes notes;
    geom::Affine map;
    for (int k = 0; k < 3; ++k) map.a[k][k] = 25.4; // of a part in inches
    auto header = told(map);
    header.history[0].settings.push_back(unit_setting(25.4));
    const auto layers = layers_of(test_loops(-50, 50), 8);
    const auto project = modifiers(file.name, header, layers, 1, notes);
    ASSERT_EQ(project.bodies.size(), 1U);
    EXPECT_NEAR(area_of(project.bodies[0].outlines, 0), 16, 1e-6);
    EXPECT_EQ(project.bodies[0].settings.at(0).second, "1");
    EXPECT_TRUE(notes.empty());
}

TEST(Modifier, ProjectsWithoutModifiersAreRefused) {
    const Project3mf file("4", "support_enforcer");
    Notes notes;
    EXPECT_THROW(modifiers(file.name, told({}), layers_of({}, 2), 1, notes), Error);
}

TEST(Modifier, PaintedFacesCountWhereTheyLookDown) {
    const auto layers = layers_of(test_loops(-50, 50), 8); // planes at 0.25, 0.75, ..
    Notes notes;
    const Project3mf wanted("4", "modifier_part"), unwanted("8", "support_enforcer");
    const auto paint = support_places(wanted.name, true, told({}), layers, 1, notes);
    EXPECT_NEAR(paint.painted, 100, 1e-9);
    for (std::size_t i = 0; i < 8; ++i) // the lower face, at z 2, lies between planes 3 and 4
        EXPECT_NEAR(area_of(paint.body.outlines, i), i == 4 ? 100 : 0, 1e-6) << i;
    EXPECT_THROW(support_places(wanted.name, false, told({}), layers, 1, notes), Error);
    const auto not_there = support_places(unwanted.name, false, told({}), layers, 1, notes);
    EXPECT_NEAR(area_of(not_there.body.outlines, 4), 100, 1e-6);
    const auto body = support_places(unwanted.name, true, told({}), layers, 1, notes);
    EXPECT_EQ(body.painted, 0);
    EXPECT_NEAR(area_of(body.body.outlines, 2), 16, 1e-6);
}

TEST(Modifier, ASlopedPaintedFaceIsDividedAmongLayers) {
    const mesh::Mesh face{{{0, 0, 0}, {0, 10, 0}, {10, 10, 4}, {10, 0, 4}}, {{0, 1, 2}, {0, 2, 3}}};
    std::vector<filum::slice::Level> levels;
    std::vector<std::uint32_t> layer;
    for (std::uint32_t i = 0; i < 10; ++i) {
        levels.push_back({0.5 * (i + 1), 0.5, 0.5 * i + 0.25});
        layer.push_back(i + 3);
    }
    const auto seen = seen_from_below(face, levels, layer);
    double all = 0;
    for (const auto& loops : seen) all += polygon::signed_area(loops);
    EXPECT_NEAR(all, 100, 1.5); // a little is of two layers
    EXPECT_NEAR(area_of(seen, 6), 12.5, 0.2);
    mesh::Mesh up = face;
    for (auto& t : up.triangles) std::swap(t[1], t[2]);
    for (const auto& loops : seen_from_below(up, levels, layer)) EXPECT_TRUE(loops.empty());
}

} // namespace filum::app::modifier
