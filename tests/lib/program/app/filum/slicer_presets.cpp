#include "app/filum/slicer_presets.hpp"

#include "../files.hpp"
#include "app/filum/slicer_names.hpp"
#include "base/error.hpp"

#include "../../../trials.hpp"
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <random>

namespace filum::app::filum {
namespace {

// n trials, or as many as $FILUM_TRIALS says.
int many(int n) {
    const char* asked = std::getenv("FILUM_TRIALS");
    return asked == nullptr ? trials(n) : std::atoi(asked);
}

std::map<std::string, std::string> as_map(const std::vector<SlicerSetting>& settings) {
    std::map<std::string, std::string> out;
    for (const SlicerSetting& s : settings) EXPECT_TRUE(out.emplace(s.key, s.value).second) << s.key << " occurs twice";
    return out;
}

std::string value_of(const SlicerFile& file, const std::string& key) {
    const auto all = as_map(file.settings);
    const auto at = all.find(key);
    return at == all.end() ? "-" : at->second;
}

TEST(SlicerPresets, NamesOfPresetsStandBehindTheFile) {
    const NamedPresets all = named_presets("a b:c.ini:printer=Mini & Co, 0.4 nozzle,print=0.2 mm: fine,filament=PLA");
    EXPECT_EQ(all.file, "a b:c.ini");
    EXPECT_EQ(all.names, (PresetNames{"Mini & Co, 0.4 nozzle", "0.2 mm: fine", "PLA"}));
    EXPECT_EQ(named_presets("x.ini").file, "x.ini");
    EXPECT_FALSE(named_presets("x.ini").any());
    EXPECT_THROW(named_presets("x.ini:printer="), Error);
    const test::Folder at;
    const std::string file = at.write("x:print=1.ini", "layer_height = 0.2\n");
    EXPECT_EQ(named_presets(file).file, file);
}

// Bundles with random ancestors, beside a plain recursion over them.
TEST(SlicerPresets, InheritedSettingsAreThoseOfAPlainRecursion) {
    std::mt19937 random(7);
    const auto below = [&](auto n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int trial = 0; trial < many(100); ++trial) {
        struct Node {
            std::vector<int> parents;
            std::map<std::string, std::string> own;
        };
        std::vector<Node> nodes(static_cast<std::size_t>(2 + below(12)));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            for (int p = below(4); p > 0 && i > 0; --p) nodes[i].parents.push_back(below(i));
            for (int k = below(5); k > 0; --k)
                nodes[i].own["key_" + std::to_string(below(6))] = std::to_string(below(99));
        }
        std::string text;
        for (std::size_t i = nodes.size(); i-- > 0;) { // children may stand before their parents
            text += "[print:p " + std::to_string(i) + "]\n";
            for (std::size_t p = 0; p < nodes[i].parents.size(); ++p)
                text += (p == 0 ? "inherits = p " : "; p ") + std::to_string(nodes[i].parents[p]);
            text += "\n";
            for (const auto& [key, value] : nodes[i].own) text += key + "=" + value + "\n";
        }
        const std::function<void(std::size_t, std::map<std::string, std::string>&)> gather = [&](std::size_t i,
                                                                                                 auto& out) {
            for (const int p : nodes[i].parents) gather(static_cast<std::size_t>(p), out);
            for (const auto& [key, value] : nodes[i].own) out[key] = value;
        };
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            std::map<std::string, std::string> want;
            gather(i, want);
            auto got =
                as_map(bundle_settings(text + "[print:other]\nz = 1\n", {"b.ini", {"", "p " + std::to_string(i), ""}})
                           .settings);
            std::erase_if(got, [](const auto& s) { return !s.first.starts_with("key_"); });
            EXPECT_EQ(got, want) << text;
        }
    }
}

constexpr const char* kBundle =
    "[vendor]\nname = V\n"
    "[printer:*base*]\nnozzle_diameter = 0.4\n"
    "[printer:One 0.6]\ninherits = *base*\nnozzle_diameter = 0.6\nrenamed_from = \"Old one\"\n"
    "default_print_profile = fine\ndefault_filament_profile = \"Some PLA\";\"Other\"\n"
    "[printer:Two]\ninherits = *base*\ndefault_print_profile = lost\n"
    "[print:fine]\nlayer_height = 0.1\ncompatible_printers_condition = nozzle_diameter[0]==9\n"
    "[print:rough]\nlayer_height = 0.4\n"
    "[filament:Some PLA]\ntemperature = 211\n";

TEST(SlicerPresets, ThePrinterNamesWhatIsNotNamed) {
    const SlicerFile usual = bundle_settings(kBundle, {"b.ini", {"One 0.6", "", ""}});
    EXPECT_EQ(value_of(usual, "nozzle_diameter"), "0.6");
    EXPECT_EQ(value_of(usual, "layer_height"), "0.1");
    EXPECT_EQ(value_of(usual, "temperature"), "211");
    EXPECT_EQ(usual.slicer, Slicer::prusa);
    EXPECT_EQ(value_of(bundle_settings(kBundle, {"b.ini", {"Old one", "rough", ""}}), "layer_height"), "0.4");
    const SlicerFile lost = bundle_settings(kBundle, {"b.ini", {"Two", "", ""}});
    ASSERT_EQ(lost.remarks.size(), 1U);
    EXPECT_NE(lost.remarks[0].find("'lost' was not found"), std::string::npos);
    const std::string active = std::string(kBundle) + "[presets]\nprint = rough\nprinter = Two\nfilament = Some PLA\n";
    EXPECT_EQ(value_of(bundle_settings(active, {"b.ini", {}}), "layer_height"), "0.4");
}

TEST(SlicerPresets, ABundleWithoutAChoiceOrWithALoopIsRefused) {
    const auto code = [](const std::string& text, const PresetNames& names) {
        try {
            bundle_settings(text, {"b.ini", names});
        } catch (const Error& e) {
            return e.exit();
        }
        return Exit::ok;
    };
    EXPECT_EQ(code(kBundle, {}), Exit::bad_input);
    EXPECT_EQ(code(kBundle, {"Three", "", ""}), Exit::usage);
    EXPECT_EQ(code("[print:a]\ninherits = b\n[print:b]\ninherits = a\n", {"", "a", ""}), Exit::bad_input);
    EXPECT_EQ(code("[print:a]\ninherits = a\n", {"", "a", ""}), Exit::bad_input);
}

// OrcaSlicer's tree: VENDOR/process/x.json inherits from others there; the user's own from those of the system.
TEST(SlicerPresets, ParentsOfJsonAreFoundWhereSlicersKeepThem) {
    const test::Folder at;
    for (const char* folder : {"system/V/process/deep", "system/W/process", "user/default/process", "alone"})
        std::filesystem::create_directories(at(folder));
    static_cast<void>(at.write("system/V/process/base.json",
                               R"({"type": "process", "name": "base", "wall_loops": "4", "layer_height": "0.3"})"));
    static_cast<void>(
        at.write("system/W/process/base.json", R"({"type": "process", "name": "base", "wall_loops": "9"})"));
    const std::string near =
        at.write("system/V/process/deep/near.json",
                 R"({"type": "process", "name": "near", "inherits": "base", "layer_height": "0.2"})");
    EXPECT_EQ(value_of(slicer_file(near), "wall_loops"), "4");
    EXPECT_EQ(value_of(slicer_file(near), "layer_height"), "0.2");
    const std::string own =
        at.write("user/default/process/own.json",
                 R"({"type": "process", "name": "own", "inherits": "near", "sparse_infill_density": "7%"})");
    EXPECT_EQ(value_of(slicer_file(own), "wall_loops"), "-");
    EXPECT_NE(slicer_file(own).remarks.at(0).find("'near', which 'own' inherits from, was not found"),
              std::string::npos);
    ::setenv("FILUM_PRESETS", at("system").c_str(), 1);
    EXPECT_EQ(value_of(slicer_file(own), "wall_loops"), "4");
    EXPECT_EQ(value_of(slicer_file(own), "sparse_infill_density"), "7%");
    ::unsetenv("FILUM_PRESETS");
}

// Random trees of vendors and of the library that all share, whose presets have equal names: a parent is that of the
// file that inherits, then that of its vendor, then that of the library.  Files may have other names than their
// presets.
TEST(SlicerPresets, ParentsAreThoseOfTheFileThatInherits) {
    std::mt19937 random(11);
    for (int trial = 0; trial < many(40); ++trial) {
        const test::Folder at;
        const auto put = [&](const std::string& folder, const std::string& name, const std::string& more) {
            std::filesystem::create_directories(at(folder));
            const std::string file = random() % 2 == 0 ? name : "file of " + name; // its name is in the JSON
            return at.write(folder + "/" + file + ".json",
                            R"({"type": "filament", "name": ")" + name + R"(", )" + more + "}");
        };
        const std::string library = "OrcaFilamentLibrary/filament";
        const bool own_base = random() % 2 == 0, own_material = random() % 2 == 0;
        for (const char* vendor : {"Alpha", "Zeta"}) // neighbours, which never count
            for (const char* name : {"base", "material"})
                static_cast<void>(put(std::string(vendor) + "/filament", name, R"("filament_cost": ["99"])"));
        static_cast<void>(put(library + "/base", "base", R"("filament_cost": ["1"])"));
        static_cast<void>(put(library, "material", R"("inherits": "base", "filament_density": ["1.1"])"));
        if (own_base) static_cast<void>(put("Mid/filament", "base", R"("filament_cost": ["2"])"));
        if (own_material)
            static_cast<void>(put("Mid/filament", "material", R"("inherits": "base", "filament_density": ["1.2"])"));
        const std::string chosen = put("Mid/filament/deep", "chosen", R"("inherits": "material")");
        const SlicerFile file = slicer_file(chosen);
        EXPECT_TRUE(file.remarks.empty());
        EXPECT_EQ(value_of(file, "filament_density"), own_material ? "1.2" : "1.1") << trial;
        EXPECT_EQ(value_of(file, "filament_cost"), own_material && own_base ? "2" : "1") << trial;
    }
}

TEST(SlicerPresets, FilesOfOneSlicerAreReadAsOne) {
    SlicerFile machine{Slicer::orca, {{"nozzle_diameter", "0.6"}, {"travel_speed", "1"}}},
        process{Slicer::orca, {{"line_width", "110%"}, {"travel_speed", "2"}}},
        other{Slicer::prusa, {{"perimeters", "2"}}};
    const auto one = merged({machine, process});
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(value_of(one[0], "travel_speed"), "2");
    EXPECT_EQ(value_of(one[0], "nozzle_diameter"), "0.6");
    EXPECT_EQ(merged({machine, other}).size(), 2U);
}

} // namespace
} // namespace filum::app::filum
