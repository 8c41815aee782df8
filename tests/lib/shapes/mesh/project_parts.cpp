// Settings of a project's objects and parts: which hold for the whole job, and which for a body.
#include "mesh/place.hpp"
#include "mesh/project.hpp"
#include "mesh/project_heights.hpp"
#include "mesh/read.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::mesh {
namespace {

using Values = std::map<std::string, std::string>;

Values values(const SlicerSettings& settings) { return {settings.begin(), settings.end()}; }

// A value in effect: of the part, else of its object, else the usual one.
std::string in_effect(const std::string& key, const Values& part, const Values& object, const Values& usual) {
    for (const Values* v : {&part, &object, &usual})
        if (const auto at = v->find(key); at != v->end()) return at->second;
    return "";
}

std::string metadata(const char* type, const Values& all) {
    std::string out;
    for (const auto& [key, value] : all)
        out += std::string("<metadata type=\"") + type + "\" key=\"" + key + "\" value=\"" + value + "\"/>";
    return out;
}

struct RandomProject {
    std::mt19937 random;
    Values usual{{"fill_density", "20%"}, {"perimeters", "2"}, {"support_material", "0"}, {"layer_height", "0.2"}};
    std::vector<Values> objects{};
    std::vector<std::vector<Values>> parts{};
    std::string config = "<config>";

    Values some() {
        Values out;
        const char* kChoices[][3] = {{"fill_density", "20%", "40%"},
                                     {"perimeters", "2", "4"},
                                     {"support_material", "0", "1"},
                                     {"layer_height", "0.2", "0.1"}};
        for (const auto& [key, first, second] : kChoices)
            if (random() % 3 == 0) out[key] = random() % 2 == 0 ? first : second;
        return out;
    }
    void make() {
        if (random() % 2 == 0) usual["support_material"] = "1";
        objects.resize(1 + random() % 3);
        for (std::size_t o = 0; o < objects.size(); ++o) {
            objects[o] = some();
            config += "<object id=\"" + std::to_string(o) + "\">" + metadata("object", objects[o]);
            parts.emplace_back(1 + random() % 3);
            for (std::size_t p = 0; p < parts[o].size(); ++p) {
                parts[o][p] = some();
                config += "<volume firstid=\"" + std::to_string(10 * p) + "\" lastid=\"" + std::to_string(10 * p + 9) +
                          "\">" + metadata("volume", parts[o][p]) + "<metadata key=\"name\" value=\"x\"/></volume>";
            }
            config += "</object>";
        }
        config += "</config>";
    }
};

} // namespace

// For any settings in any place of a project: each part gets, by the job's settings and those of its body, what it has
// in the slicer.
TEST(ProjectParts, EachHasItsSettings) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        RandomProject made{std::mt19937(seed)};
        made.make();
        Project read;
        ASSERT_TRUE(read_prusa_project(made.config, read));
        read.divide_settings(1, [&](const std::string& key) { return made.usual.at(key); });
        const Values job = values(read.shared);
        bool same = true; // whether all parts have the same values in effect
        Values first;
        for (std::size_t o = 0; o < made.objects.size(); ++o)
            for (std::size_t p = 0; p < made.parts[o].size(); ++p) {
                const std::size_t body = read.of_triangle(std::to_string(o), 10 * p + 3);
                EXPECT_TRUE(read.printed(body));
                const Values own = body == Project::kNone ? Values{} : values(read.bodies[body].settings);
                for (const auto& [key, usual] : made.usual) {
                    const std::string wanted = in_effect(key, made.parts[o][p], made.objects[o], made.usual);
                    EXPECT_EQ(in_effect(key, own, job, made.usual), wanted) << seed << ": " << key;
                    same = same && first.try_emplace(key, wanted).first->second == wanted;
                }
            }
        EXPECT_TRUE(!same || read.bodies.empty()) << seed;
        for (const Body& b : read.bodies) EXPECT_FALSE(wants_supports(b, true)) << seed; // the job has supports then
    }
}

// Parts on other plates have no say in the settings of this one.
TEST(ProjectParts, OfOnePlate) {
    std::string config = "<config>";
    for (const char* id : {"1", "2"})
        config += std::string("<object id=\"") + id + "\"><metadata key=\"wall_loops\" value=\"" + id +
                  "\"/><part id=\"7\" subtype=\"normal_part\"/></object>";
    for (const char* id : {"1", "2"})
        config += std::string("<plate><model_instance><metadata key=\"object_id\" value=\"") + id +
                  "\"/></model_instance></plate>";
    config += "</config>";
    for (const int plate : {1, 2}) {
        Project read;
        ASSERT_TRUE(read_bambu_project(config, read));
        read.divide_settings(plate, [](const std::string&) { return "3"; });
        EXPECT_EQ(values(read.shared), (Values{{"wall_loops", std::to_string(plate)}}));
        EXPECT_TRUE(read.bodies.empty());
    }
}

// A part with settings of its own is printed and is a body, too; modifiers come after it. Paint of other kinds counts.
TEST(ProjectParts, ArePrinted) {
    Mesh both = shapes::box({0, 0, 0}, {10, 10, 10});
    const Mesh more = shapes::box({10, 0, 0}, {20, 10, 10});
    for (const auto& t : more.triangles) both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    both.vertices.insert(both.vertices.end(), more.vertices.begin(), more.vertices.end());
    std::string mesh = shapes::model_mesh(both);
    mesh.replace(mesh.find("<triangle ") + 9, 1, " paint_seam=\"4\" ");
    const std::string model = "<model><resources><object id=\"1\">" + mesh +
                              "</object></resources><build><item objectid=\"1\"/></build></model>";
    const std::string config = "<config><object id=\"1\"><volume firstid=\"0\" lastid=\"11\"/><volume firstid=\"12\" "
                               "lastid=\"23\"><metadata key=\"perimeters\" value=\"5\"/></volume></object></config>";
    const File f = read(shapes::archive(model, {{"Metadata/Slic3r_PE_model.config", config}}), "it");
    EXPECT_NEAR(volume(f.mesh), 2000, 1e-9);
    ASSERT_EQ(f.bodies.size(), 2U);
    EXPECT_TRUE(f.bodies[0].printed);
    EXPECT_NEAR(volume(f.bodies[0].mesh), 1000, 1e-9);
    EXPECT_EQ(f.bodies[1].what, Body::Purpose::painted_seam);
    std::map<NoteCode, std::uint64_t> notes;
    for (const Note& n : f.notes) notes[n.code] += n.count;
    EXPECT_EQ(notes[NoteCode::project_part_settings], 1U);
    EXPECT_EQ(notes[NoteCode::project_paint_unused], 1U);
}

TEST(ProjectHeights, CodesAndWhatIsNotFollowed) {
    const std::string mesh = shapes::model_mesh(shapes::box({0, 0, 0}, {10, 10, 10}));
    const std::string bytes = shapes::archive(
        "<model><resources><object id=\"1\">" + mesh +
            "</object></resources><build><item objectid=\"1\"/></build></model>",
        {{"Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
          "<custom_gcodes_per_print_z><code print_z=\"4\" type=\"1\"/><code print_z=\"2\" type=\"0\"/><code "
          "print_z=\"5\" type=\"4\" extra=\"G4 S1\"/></custom_gcodes_per_print_z>"},
         {"Metadata/Slic3r_PE_layer_heights_profile.txt", "object_id=1|0;0.2;10;0.2"},
         {"Metadata/Prusa_Slicer_layer_config_ranges.xml",
          "<objects><object id=\"1\"><range min_z=\"0\" max_z=\"5\"><option "
          "opt_key=\"perimeters\">3</option></range></object></objects>"}});
    archive::Zip zip(bytes, "it");
    const auto codes = codes_by_height(zip, 1);
    ASSERT_EQ(codes.size(), 3U);
    EXPECT_EQ(codes[0].what, HeightCode::Kind::colour);
    EXPECT_EQ(codes[1].what, HeightCode::Kind::pause);
    EXPECT_EQ(codes[2].code, "G4 S1");
    std::vector<std::string> details;
    for (const Note& n : read(bytes, "it").notes)
        if (n.code == NoteCode::project_metadata_unused) details.push_back(n.detail);
    EXPECT_EQ(details, (std::vector<std::string>{"layer heights by height", "settings by height (perimeters)"}));
}

} // namespace filum::mesh
