#include "app/metrics/metrics.hpp"

#include "../files.hpp"
#include "wire/planar.hpp"
#include "wire/surface.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

namespace filum::app::metrics {
namespace {

using namespace test;
using stream::Payload;
using toolpath::Role;
using toolpath::Span;

// key: value, of what was written as TSV.
std::map<std::string, std::string> measured(const Folder& at, Options o, const std::string& input) {
    o.plane.format = "tsv";
    run(o, io("metrics", input, at("figures")));
    std::map<std::string, std::string> out;
    std::istringstream lines(at.text("figures"));
    for (std::string line; std::getline(lines, line);) {
        const auto a = line.find('\t'), b = line.find('\t', a + 1);
        out[line.substr(0, a)] = line.substr(a + 1, b - a - 1);
    }
    return out;
}

double number(const std::map<std::string, std::string>& all, const std::string& name) {
    const auto at = all.find(name);
    return at == all.end() ? std::nan("") : std::stod(at->second);
}

// Four rows 1 mm wide in a rectangle of 10 by 4 mm, their round ends on its short sides.
constexpr double kRow = 9 + std::numbers::pi / 4; // mm2 that one covers

std::string rectangle(const Folder& at) {
    polygon::Region r;
    r.z = 0.2;
    r.height = 0.2;
    r.area = 40;
    r.loops.add(std::vector<geom::Vec2>{{0, 0}, {10, 0}, {10, 4}, {0, 4}});
    return write_stream(at("regions"), Payload::regions, {wire::frame(r)});
}

Span row(std::uint32_t k) {
    const double y = 0.5 + k;
    return {Role::bead, k, 0, 0, {{0.5, y, 0.2}, {9.5, y, 0.2}}, {1}, {0.2}};
}

std::string rows(const Folder& at) {
    std::vector<stream::RawFrame> frames;
    for (std::uint32_t k = 0; k < 4; ++k) {
        if (k > 0)
            frames.push_back(
                wire::frame(Span{Role::travel, k, 0, 0, {row(k - 1).points.back(), row(k).points.front()}, {}, {}}));
        frames.push_back(wire::frame(row(k)));
    }
    return write_stream(at("rows"), Payload::toolpath, frames, {{NoteCode::wall_doubled, 0.25}});
}

TEST(Planar, MeasuresRowsOfKnownArea) {
    const Folder at;
    Options o;
    o.plane.regions = rectangle(at);
    const auto figures = measured(at, o, rows(at));
    EXPECT_EQ(number(figures, "strokes"), 4);
    EXPECT_EQ(number(figures, "stops"), 3);
    EXPECT_NEAR(number(figures, "coverage"), 4 * kRow / 40, 1e-3);
    EXPECT_NEAR(number(figures, "material"), 36.0 / 40, 1e-5);
    EXPECT_EQ(number(figures, "crossings"), 0);
    EXPECT_EQ(number(figures, "regions"), 1);
}

TEST(Planar, TellsWithoutOutlinesWhatNeedsNone) {
    const Folder at;
    const auto figures = measured(at, {}, rows(at));
    EXPECT_EQ(number(figures, "strokes"), 4);
    EXPECT_FALSE(figures.contains("coverage"));
}

TEST(Planar, TakesTheCurvesOfAFill) {
    const Folder at;
    toolpath::RegionPaths p;
    p.z = 0.2;
    p.height = 0.2;
    p.area = 40;
    p.unplaced = 0.5;
    for (std::uint32_t k = 0; k < 4; ++k) p.curves.push_back({false, {{0.5, 0.5 + k}, {9.5, 0.5 + k}}, {1}});
    Options o;
    o.plane.regions = rectangle(at);
    const auto figures = measured(at, o, write_stream(at("paths"), Payload::paths, {wire::frame(p)}));
    EXPECT_NEAR(number(figures, "coverage"), 4 * kRow / 40, 1e-3);
    EXPECT_EQ(number(figures, "unplaced_claimed_mm2"), 0.5);
    EXPECT_NEAR(number(figures, "unplaced_mm2"), 40 - 4 * kRow, 0.05); // what is so
    EXPECT_FALSE(figures.contains("stops"));                           // each curve counts by itself
}

TEST(Planar, ListsLayersAndRegionsInFiles) {
    const Folder at;
    Options o;
    o.plane.regions = rectangle(at);
    o.plane.per_region = at("by-region");
    o.plane.per_layer = at("by-layer");
    measured(at, o, rows(at));
    for (const char* name : {"by-region", "by-layer"}) {
        const std::string text = at.text(name);
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << name; // a head line, and one
    }
}

TEST(Planar, RefusesWhatDoesNotGoTogether) {
    const Folder at;
    const std::string input = rows(at);
    Options pores, voids, spacing;
    pores.plane.pores = true;
    voids.voids = at("v");
    spacing.curved.spacing = 1;
    for (const Options& o : {pores, voids, spacing}) {
        EXPECT_EQ(refusal([&] { measured(at, o, input); }).exit, 2);
        EXPECT_FALSE(at.has("figures"));
    }
    const Refusal layers = refusal([&] { measured(at, {}, write_stream(at("l"), Payload::layers, {})); });
    EXPECT_EQ(layers.exit, 3);
    EXPECT_TRUE(tells(layers.what, "it carries Layers, not Toolpath or Paths")) << layers.what;
}

// A plate of 10 by 4 mm in z = 0, as two triangles.
std::string plate(const Folder& at, int count = 1) {
    surface::Sheet s;
    s.surface = surface::assemble({{0, 0, 0}, {10, 0, 0}, {10, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}},
                                  {surface::kNone, surface::kNone, 3, 2, surface::kNone, surface::kNone});
    return write_stream(at("plate" + std::to_string(count)), Payload::surface,
                        std::vector<stream::RawFrame>(static_cast<std::size_t>(count), wire::frame(s)));
}

// The same rows lying on it, from side to side.
std::string fibres(const Folder& at) {
    std::vector<stream::RawFrame> frames;
    for (std::uint32_t k = 0; k < 4; ++k) {
        Span s{Role::bead, k, 0, 0, {{0, 0.5 + k, 0}, {10, 0.5 + k, 0}}, {1}, {0.2}};
        s.normals = {{0, 0, 1}, {0, 0, 1}};
        frames.push_back(wire::frame(s));
    }
    return write_stream(at("fibres"), Payload::toolpath, frames);
}

TEST(Curved, RowsAtOneWidthCoverAPlate) {
    const Folder at;
    Options o;
    o.surface = plate(at);
    o.voids = at("voids");
    const auto figures = measured(at, o, fibres(at));
    EXPECT_NEAR(number(figures, "coverage"), 1, 1e-3);
    EXPECT_FALSE(figures.contains("stops")); // that speaks of layers
    const auto voids = read_stream(o.voids, Payload::surface);
    ASSERT_EQ(voids.frames.size(), 1U);
    EXPECT_EQ(voids.told.header.history.back().parents.size(), 2U); // of the plate and of the path
    const auto sheet = wire::sheet(voids.frames[0]);
    ASSERT_EQ(sheet.fields.size(), 1U);
    EXPECT_EQ(sheet.fields[0].name, "path-distance");
    EXPECT_NEAR(*std::max_element(sheet.fields[0].values.begin(), sheet.fields[0].values.end()), 0.5, 0.01);
}

TEST(Curved, RefusesOptionsOfLayersAndMoreThanOneSurface) {
    const Folder at;
    const std::string input = fibres(at);
    Options layers;
    layers.surface = plate(at);
    layers.plane.regions = rectangle(at);
    const Refusal both = refusal([&] { measured(at, layers, input); });
    EXPECT_EQ(both.exit, 2);
    EXPECT_TRUE(tells(both.what, "'--regions'")) << both.what;
    Options two;
    two.surface = plate(at, 2);
    const Refusal many = refusal([&] { measured(at, two, input); });
    EXPECT_EQ(many.exit, 3);
    EXPECT_TRUE(tells(many.what, "it holds 2 surfaces, not one")) << many.what;
}

} // namespace
} // namespace filum::app::metrics
