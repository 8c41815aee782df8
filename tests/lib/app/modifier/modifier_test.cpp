// Bodies are put where the part was, and cut where it is.
#include "app/modifier/modifier.hpp"

#include "../../mesh/shapes.hpp"
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
    EXPECT_FALSE(placement_in(two)); // nobody knows of which part the body is
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
    EXPECT_EQ(notes[0].what, "body meets nothing of the part");
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

} // namespace filum::app::modifier
