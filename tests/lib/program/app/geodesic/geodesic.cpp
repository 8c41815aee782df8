#include "app/geodesic/geodesic.hpp"

#include "../files.hpp"
#include "wire/surface.hpp"

#include <cmath>

namespace filum::app::geodesic {
namespace {

using namespace test;
using stream::Payload;

// A square of 2 by 2 mm in z = 0 with a vertex in its middle, the last one.
constexpr const char* kSquare = "OFF\n5 4 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

surface::Sheet made(const Folder& at, const Options& o, const std::string& input, Stream* all = nullptr) {
    run(o, io("geodesic", input, at("out")));
    Stream s = read_stream(at("out"), Payload::surface);
    EXPECT_EQ(s.frames.size(), 1U);
    const auto sheet = wire::sheet(s.frames.at(0));
    if (all != nullptr) *all = std::move(s);
    return sheet;
}

const stream::Setting* setting(const stream::Header& h, const std::string& name) {
    for (const auto& s : h.history.back().settings)
        if (s.name == name) return &s;
    return nullptr;
}

TEST(Geodesic, MeasuresFromACornerOfAMeshFile) {
    const Folder at;
    Options o;
    o.source = "vertex:0";
    o.measure.method = filum::geodesic::Method::exact;
    Stream all;
    const auto sheet = made(at, o, at.write("part.off", kSquare), &all);
    ASSERT_EQ(sheet.fields.size(), 1U);
    const std::vector<double> expected{0, 2, std::sqrt(8), 2, std::sqrt(2)};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(sheet.fields[0].values[i], expected[i], 1e-9) << i;
    EXPECT_EQ(find(all.told.facts, "geodesic", "area")->value, 4);
}

TEST(Geodesic, KnowsItsInputByContentNotByName) {
    const Folder at;
    Stream one, other;
    made(at, {}, at.write("part.off", kSquare), &one);
    made(at, {}, at.write("copy.off", kSquare), &other);
    ASSERT_NE(setting(one.told.header, "input_crc32c"), nullptr);
    EXPECT_EQ(setting(one.told.header, "input_crc32c")->value, setting(other.told.header, "input_crc32c")->value);
    std::string changed = kSquare;
    changed.replace(changed.find("1 1 0"), 5, "1 1 1");
    made(at, {}, at.write("part.off", changed), &other);
    EXPECT_NE(setting(one.told.header, "input_crc32c")->value, setting(other.told.header, "input_crc32c")->value);
}

TEST(Geodesic, MeasuresAStreamAgainAndItsOldFactsGo) {
    const Folder at;
    Options corner, opposite;
    corner.source = "vertex:0";
    opposite.source = "vertex:2";
    made(at, corner, at.write("part.off", kSquare));
    std::filesystem::rename(at("out"), at("first"));
    Stream all;
    const auto sheet = made(at, opposite, at("first"), &all);
    ASSERT_EQ(sheet.fields.size(), 1U);
    EXPECT_NEAR(sheet.fields[0].values[0], std::sqrt(8), 1e-6);
    std::size_t areas = 0;
    for (const Fact& f : all.told.facts) areas += f.name == "area" ? 1 : 0;
    EXPECT_EQ(areas, 1U);
    EXPECT_EQ(all.told.header.history.size(), 2U);
}

TEST(Geodesic, CutsAndSaysWhichLinesGo) {
    const Folder at;
    Options lines;
    lines.source = "vertex:0", lines.measure.levels = {0.5, 1};
    EXPECT_EQ(made(at, lines, at.write("part.off", kSquare)).isolines.size(), 2U);
    std::filesystem::rename(at("out"), at("lines"));
    Options half;
    half.shape.cut = {1, 0, 0, 1}; // keep x <= 1
    Stream all;
    const auto sheet = made(at, half, at("lines"), &all);
    EXPECT_NEAR(surface::area(sheet.surface), 2, 1e-9);
    EXPECT_TRUE(sheet.isolines.empty());
    ASSERT_EQ(sheet.fields.size(), 1U); // carried over
    std::vector<std::string> noted;
    for (const Note& n : all.told.notes) noted.push_back(code_name(n) + " " + std::to_string(n.count));
    EXPECT_EQ(noted, (std::vector<std::string>{"isoline-dropped 2", "source-dropped 1"}));
}

TEST(Geodesic, TakesSourcesFromFiles) {
    const Folder at;
    Options o;
    o.lines = at.write("line.txt", "0 0 0\n0 2 0\n"); // the side x = 0
    o.measure.method = filum::geodesic::Method::exact;
    const auto sheet = made(at, o, at.write("part.off", kSquare));
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(sheet.fields.at(0).values[i], sheet.surface.vertices[i].x, 1e-6) << i;
    Options wall;
    wall.mesh = at.write("wall.off", "OFF\n4 2 0\n1 -1 -1\n1 3 -1\n1 3 1\n1 -1 1\n3 0 1 2\n3 0 2 3\n"); // x = 1
    wall.measure.method = filum::geodesic::Method::exact;
    const auto split = made(at, wall, at("part.off"));
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(split.fields.at(0).values[i], std::abs(split.surface.vertices[i].x - 1), 1e-6) << i;
}

TEST(Geodesic, RefusesWhatHasNoSense) {
    const Folder at;
    const std::string mesh = at.write("part.off", kSquare);
    Options levels, sides, inches;
    levels.measure.levels = {1}, sides.measure.with_sides = true, inches.place.unit = "in";
    EXPECT_EQ(refusal([&] { made(at, levels, mesh); }).exit, 2); // isolines of nothing
    EXPECT_EQ(refusal([&] { made(at, sides, mesh); }).exit, 2);
    made(at, {}, mesh);
    const auto frame = read_stream(at("out"), Payload::surface).frames.at(0);
    const Refusal unit = refusal([&] { run(inches, io("geodesic", at("out"), at("again"))); });
    EXPECT_EQ(unit.exit, 2);
    EXPECT_TRUE(tells(unit.what, "--unit")) << unit.what;
    const auto two = write_stream(at("two"), Payload::surface, {frame, frame});
    const Refusal many = refusal([&] { run({}, io("geodesic", two, at("again"))); });
    EXPECT_EQ(many.exit, 3);
    EXPECT_TRUE(tells(many.what, "2 surfaces, not one")) << many.what;
    EXPECT_FALSE(at.has("again"));
}

} // namespace
} // namespace filum::app::geodesic
