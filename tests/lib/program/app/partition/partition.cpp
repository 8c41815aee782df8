#include "app/partition/partition.hpp"

#include "../files.hpp"
#include "wire/surface.hpp"

namespace filum::app::partition {
namespace {

using namespace test;
using stream::Payload;

// A roof: two squares of 4 by 4 mm that meet at a right angle, each a grid of n by n cells.
surface::Sheet roof(std::uint32_t n, double shift = 0) {
    mesh::Mesh m;
    for (std::uint32_t i = 0; i <= 2 * n; ++i)
        for (std::uint32_t j = 0; j <= n; ++j) {
            const double along = 4.0 * i / n;
            m.vertices.push_back({shift + std::min(along, 4.0), 4.0 * j / n, std::min(0.0, 4 - along)});
        }
    for (std::uint32_t i = 0; i < 2 * n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
            m.triangles.push_back({a, b, b + 1});
            m.triangles.push_back({a, b + 1, a + 1});
        }
    Notes none;
    surface::Sheet out;
    out.surface = surface::connect(std::move(m), none);
    return out;
}

std::vector<surface::Sheet> patches(const Folder& at, const Options& o, const std::vector<std::string>& inputs,
                                    Stream* all = nullptr) {
    cli::Io self = io("partition", inputs.at(0), at("out"));
    self.inputs = inputs;
    run(o, self);
    Stream s = read_stream(at("out"), Payload::surface);
    std::vector<surface::Sheet> out;
    for (const auto& f : s.frames) out.push_back(wire::sheet(f));
    if (all != nullptr) *all = std::move(s);
    return out;
}

std::string write_roof(const Folder& at, const std::string& name, double shift = 0) {
    return write_stream(at(name), Payload::surface, {wire::frame(roof(6, shift))}, {}, {{"", "area", 32, "mm2"}});
}

std::vector<std::string> names(const std::vector<surface::Sheet>& all) {
    std::vector<std::string> out;
    for (const auto& s : all) out.push_back(s.name);
    return out;
}

TEST(Partition, DividesARoofAlongItsRidge) {
    const Folder at;
    Stream all;
    const auto found = patches(at, {}, {write_roof(at, "roof")}, &all);
    ASSERT_EQ(names(found), (std::vector<std::string>{"A", "B"}));
    for (const auto& p : found) {
        EXPECT_NEAR(surface::area(p.surface), 16, 1e-9);
        const auto level = [&](const geom::Vec3& v) { return v.z == 0; };
        const auto upright = [&](const geom::Vec3& v) { return v.x == 4; };
        const auto& v = p.surface.vertices;
        EXPECT_TRUE(std::all_of(v.begin(), v.end(), level) || std::all_of(v.begin(), v.end(), upright));
    }
    EXPECT_NE(find(all.told.facts, "before", "area"), nullptr); // of the stage before: goes along
    EXPECT_EQ(all.told.header.expected, 2U);
}

TEST(Partition, TakesSeveralStreamsAndLeavesWhatHasAName) {
    const Folder at;
    const auto first = patches(at, {}, {write_roof(at, "roof")});
    std::filesystem::rename(at("out"), at("patches"));
    Options o;
    o.as_is = true;
    o.names = "C";
    Stream all;
    const auto found = patches(at, o, {at("patches"), write_roof(at, "other", 10)}, &all);
    EXPECT_EQ(names(found), (std::vector<std::string>{"A", "B", "C"}));
    EXPECT_NEAR(surface::area(found[2].surface), 32, 1e-9); // not divided
    EXPECT_EQ(all.told.header.history.back().parents.size(), 2U);
    // facts of the first run speak of what was before: each is there once
    std::map<std::string, int> count;
    for (const Fact& f : all.told.facts)
        if (f.stage == "partition") ++count[f.name];
    EXPECT_FALSE(count.empty());
    for (const auto& [name, n] : count) EXPECT_EQ(n, 1) << name;
}

TEST(Partition, WritesOnlyWhatIsAskedFor) {
    const Folder at;
    Options o;
    o.only = "B";
    EXPECT_EQ(names(patches(at, o, {write_roof(at, "roof")})), std::vector<std::string>{"B"});
    o.only = "Z";
    EXPECT_EQ(refusal([&] { patches(at, o, {at("roof")}); }).exit, 2);
}

TEST(Partition, BordersByLinesInAFile) {
    const Folder at;
    Options o;
    o.seam = at.write("seam.txt", "0 2 0\n4 2 0\n"); // across the level side
    Stream all;
    const auto found = patches(at, o, {write_roof(at, "roof")}, &all);
    EXPECT_EQ(found.size(), 3U);
    bool known = false;
    for (const auto& s : all.told.header.history.back().settings) known = known || s.name == "seam_crc32c";
    EXPECT_TRUE(known);
    EXPECT_EQ(refusal([&] {
                  o.seam = at("nowhere");
                  patches(at, o, {at("roof")});
              }).exit,
              5);
}

} // namespace
} // namespace filum::app::partition
