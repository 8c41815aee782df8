#include "../files.hpp"
#include "app/filum/cura_file.hpp"
#include "app/filum/cura_printer.hpp"
#include "app/filum/cura_stack.hpp"
#include "app/filum/slicer_settings.hpp"
#include "app/filum/slicer_text.hpp"
#include "archive/zip.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace filum::app::filum {
namespace {

const std::string kHead =
    "[general]\nversion = 4\nname = mine\ndefinition = custom\n\n[metadata]\ntype = quality_changes\n";

std::string profile(const std::string& values, const std::string& position = "") {
    return kHead + (position.empty() ? "" : "position = " + position + "\n") + "\n[values]\n" + values;
}

SlicerFile read(const std::string& bytes, const std::string& name = "x") {
    auto out = cura_file(bytes, name);
    EXPECT_TRUE(out.has_value()) << bytes.substr(0, 200);
    return out ? merged({*std::move(out)}).front() : SlicerFile{};
}

std::string value(const SlicerFile& file, const std::string& key) {
    const auto at = std::ranges::find(file.settings, key, &SlicerSetting::key);
    return at == file.settings.end() ? "-" : at->value;
}

// The options for a profile's values.
std::set<std::string> words(const std::string& values) {
    const auto all = wishes(read(profile(values)), [](std::string_view) { return true; }).words;
    return {all.begin(), all.end()};
}

// The comments at the end of a program, as Cura writes them: JSON with doubled backslashes, in lines of 80 letters.
std::string as_comments(const std::string& ini) {
    std::string json = R"({"global_quality": ")";
    for (const char c : ini) json += c == '\n' ? std::string(R"(\\n)") : std::string(1, c);
    json += R"("})";
    std::string out = ";FLAVOR:Marlin\n;Layer height: 0.28\nG28\n;End of Gcode\n";
    for (std::size_t at = 0; at < json.size(); at += 69) out += ";SETTING_3 " + json.substr(at, 69) + "\n";
    return out;
}

TEST(Cura, AllFormsOfAProfileHoldTheSameSettings) {
    const std::string values =
        "infill_sparse_density = 0.5\nwall_line_count = 4\nsupport_enable = True\nspeed_print = 50\n";
    const SlicerFile ini = read(profile(values));
    EXPECT_EQ(ini.slicer, Slicer::cura);
    EXPECT_EQ(value(ini, "support_enable"), "1");
    EXPECT_EQ(value(ini, "speed_wall_0"), "25");
    const SlicerFile zip = read(archive::zipped({{"mine", profile("wall_line_count = 3\nspeed_print = 50\n")},
                                                 {"mine_extruder", profile(values, "0")},
                                                 {"mine_extruder_2", profile("wall_line_count = 9\n", "1")}}));
    const SlicerFile code = read(as_comments(profile(values)));
    for (const char* key :
         {"infill_sparse_density", "wall_line_count", "support_enable", "speed_print", "speed_wall_0"}) {
        EXPECT_EQ(value(zip, key), value(ini, key)) << key;
        EXPECT_EQ(value(code, key), value(ini, key)) << key;
    }
    EXPECT_EQ(value(code, "layer_height"), "0.28");
    EXPECT_EQ(zip.remarks.front(), "1 settings of further extruders are not used: one extruder prints");
}

TEST(Cura, ValuesHaveItsUnitsAndDefaults) {
    const auto all =
        words("layer_height = 0.2\ninfill_sparse_density = 0.5\nwall_thickness = 1.2\nline_width = 0.4\n"
              "top_bottom_thickness = 0.8\nbottom_layers = 0\nmaterial_flow = 95\nsupport_enable = True\n"
              "support_angle = 55\nsupport_type = buildplate\nretraction_amount = 5\nadhesion_type = brim\n"
              "material_shrinkage_percentage = 100.5\nxy_offset = -0.1\ncool_fan_speed = 50\n"
              "cool_fan_full_layer = 4\nspeed_wall = =speed_print / 2\nspeed_print = 60\nz_seam_type = random\n");
    for (const char* word :
         {"--layer-height=0.2", "--infill=0.5%", "--walls=3", "--bead-width=0.4", "--top=4", "--bottom=0",
          "--set=extrusion.flow=0.95", "--support", "--support-angle=55", "--support-on=bed", "--set=travel.retract=5",
          "--brim=8", "--xy-compensation=-0.1", "--set=cooling.most=127.5", "--set=cooling.full_layer=5",
          "--set=cooling.off_layers=1", "--set=feeds.solid=30", "--set=feeds.infill=60", "--interlace=random"})
        EXPECT_TRUE(all.contains(word)) << word;
    EXPECT_TRUE(all.contains("--set=feeds.outer_wall=30"));
    EXPECT_FALSE(all.contains("--bottom=4"));
    EXPECT_TRUE(words("retraction_enable = False\nretraction_amount = 5\n").contains("--set=travel.retract=0"));
    EXPECT_TRUE(words("acceleration_print = 800\n").empty()) << "acceleration_enabled is off by default";
    EXPECT_TRUE(
        words("acceleration_enabled = True\nacceleration_print = 800\n").contains("--set=motion.acceleration=800"));
    EXPECT_TRUE(words("magic_spiralize = True\n").contains("--vase"));
}

TEST(Cura, WhatCannotBeCalculatedIsNamed) {
    const SlicerWishes all =
        wishes(read(profile("wall_thickness = =hash(3)\nline_width = 0.4\nwall_line_width_0 = =magic * 2\n")),
               [](std::string_view) { return true; });
    const auto at = [&](const char* key) { return *std::ranges::find(all.settings, key, &ReadSetting::key); };
    EXPECT_EQ(at("wall_thickness").use, Use::later);
    EXPECT_NE(at("wall_thickness").why.find("formula of Cura: it calls hash()"), std::string::npos);
    EXPECT_NE(at("wall_line_width_0").why.find("no file has 'magic'"), std::string::npos);
    EXPECT_EQ(at("line_width").use, Use::later); // the width of outer walls is unknown, and so are all
    EXPECT_NE(at("line_width").why.find("'wall_line_width_0' is unknown"), std::string::npos);
}

// The root's formulas win over a printer's plain default, as in Cura, and set nothing by themselves.
TEST(Cura, TheRootLiesBeneathThePrinter) {
    const test::Folder folder;
    (void)folder.write("fdmprinter.def.json", R"({"metadata": {"visible": true}, "settings": {"speed": {"children": {
        "speed_print": {"default_value": 60}, "speed_topbottom": {"value": "speed_print / 3", "default_value": 1},
        "top_thickness": {"value": "layer_height * 5"}, "odd": {"value": "missing", "default_value": 7},
        "layer_height": {"default_value": 0.15}}}, "machine": {"children": {"machine_width": {"default_value": 100}}}}})");
    (void)folder.write("x.def.json", R"({"metadata": {"visible": true}, "inherits": "fdmprinter", "overrides": {
        "speed_topbottom": {"default_value": 5}, "wall_thickness": {"value": "layer_height * 4"},
        "bottom_thickness": {"value": "odd"}}})");
    const std::string path = folder("x.def.json");
    const SlicerFile file = read(content_of(path), path);
    EXPECT_EQ(value(file, "speed_topbottom"), "20");
    EXPECT_EQ(value(file, "wall_thickness"), "0.6");
    EXPECT_EQ(value(file, "bottom_thickness"), "=odd"); // no plain default stands in without a word
    EXPECT_EQ(value(file, "machine_width"), "100");
    for (const char* key : {"speed_print", "top_thickness", "layer_height"}) EXPECT_EQ(value(file, key), "-") << key;
}

TEST(Cura, FormulasReferToAllFiles) {
    auto printer = cura_file(R"({"metadata": {"visible": true}, "inherits": "fdmprinter", "overrides": {
        "line_width": {"value": "machine_nozzle_size * 1.1"}, "machine_nozzle_size": {"default_value": 0.6},
        "wall_thickness": {"value": "line_width * 2 if adhesion_type == 'brim' else 9"}}})",
                             "x.def.json");
    ASSERT_TRUE(printer.has_value());
    const SlicerFile all = merged({*printer, *cura_file(profile("machine_nozzle_size = 0.8\n"), "y")}).front();
    EXPECT_EQ(value(all, "line_width"), "0.88");
    EXPECT_EQ(value(all, "wall_thickness"), "1.76");
}

std::string definition(const std::string& parent, const std::string& settings) {
    return R"({"version": 2, "name": "X", )" + (parent.empty() ? "" : R"("inherits": ")" + parent + R"(", )") +
           R"("metadata": {"machine_extruder_trains": {"0": "x_extruder"}}, "overrides": {)" + settings + "}}";
}

TEST(Cura, APrinterInheritsAndHeatsBeforeItsStart) {
    const test::Folder folder;
    std::filesystem::create_directories(folder("definitions"));
    std::filesystem::create_directories(folder("extruders"));
    const auto put = [&](const char* name, const std::string& text) { (void)folder.write(name, text); };
    put("extruders/x_extruder.def.json",
        R"({"metadata": {}, "inherits": "fdmextruder", "overrides": {"machine_nozzle_size": {"default_value": 0.6},
        "material_diameter": {"default_value": 2.85}}})");
    put("definitions/base.def.json",
        definition("", R"("machine_width": {"default_value": 200}, "machine_depth": {"default_value": 180},
        "machine_heated_bed": {"default_value": true}, "speed_print": {"value": 44},
        "machine_start_gcode": {"default_value": "G28 [x]\nG1 F{speed_travel}\n; {odd}"})"));
    put("definitions/x.def.json",
        definition("base", R"("machine_width": {"value": "210"}, "machine_center_is_zero": {"default_value": true},
        "z_seam_type": {"value": "'back'"}, "material_print_temperature": {"value": 222},
        "wall_thickness": {"value": "line_width * 2", "default_value": 1},
        "top_thickness": {"value": "magic", "default_value": 1})"));
    const std::string path = folder("definitions/x.def.json");
    const SlicerFile file = read(content_of(path), path);
    EXPECT_EQ(value(file, "machine_width"), "210");
    EXPECT_EQ(value(file, "z_seam_type"), "back");
    EXPECT_EQ(value(file, "machine_nozzle_size"), "0.6");
    EXPECT_EQ(value(file, "wall_thickness"), "1.2"); // the line has the nozzle's width
    EXPECT_EQ(value(file, "top_thickness"), "1");    // the plain default instead of the formula, with a remark
    EXPECT_EQ(file.remarks.back(), "plain values instead of formulas of Cura: top_thickness");
    EXPECT_EQ(value(file, "speed_print"), "-"); // the root counts for the printer only
    const SlicerFile printer = cura_printer(file);
    EXPECT_EQ(value(printer, "bed_shape"), "-105x-90,105x-90,105x90,-105x90");
    EXPECT_EQ(value(printer, "temperature"), "222");
    EXPECT_EQ(value(printer, "filament_diameter"), "2.85");
    EXPECT_EQ(value(printer, "start_gcode"),
              R"({if first_layer_bed_temperature[0] > 0}M140 S{first_layer_bed_temperature[0]}\nM190 )"
              R"(S{first_layer_bed_temperature[0]}\n{endif}M104 S{first_layer_temperature[0]}\n)"
              R"(M109 S{first_layer_temperature[0]}\nG28 {"["}x]\nG1 F{speed_travel}\n; {"{"}odd})");
}

TEST(Cura, StartCodesThatHeatAreLeftAlone) {
    const auto start = [](const std::string& code) {
        SlicerFile file{.slicer = Slicer::cura, .settings = {{"machine_start_gcode", code}}, .remarks = {}};
        return value(cura_printer(file), "start_gcode");
    };
    EXPECT_EQ(start("M109 S{material_print_temperature_layer_0, initial_extruder_nr}"),
              "M109 S{first_layer_temperature[0]}");
    EXPECT_EQ(start("START T={material_print_temperature}"), "START T={temperature[0]}");
    EXPECT_TRUE(start("; material_print_temperature").starts_with("M104"));
    EXPECT_EQ(start("{if material_print_temperature > 200}M1{elif layer_height == 1}M2{else}M3{endif}"),
              "{if temperature[0] > 200}M1{elsif layer_height == 1}M2{else}M3{endif}");
    SlicerFile griffin{.slicer = Slicer::cura,
                       .settings = {{"machine_start_gcode", ""}, {"machine_gcode_flavor", "Griffin"}},
                       .remarks = {}};
    EXPECT_THROW(cura_printer(griffin), Error);
}

TEST(Cura, WordsAndFormulasAreNoNumbers) {
    const SlicerFile file{.slicer = Slicer::cura,
                          .settings = {{"top_bottom_pattern", "lines"},
                                       {"line_width", "=x"},
                                       {"speed_print", "50"},
                                       {"machine_start_gcode", "G1 F{speed_wall_x}"},
                                       {"machine_max_feedrate_x", "299792458000"}},
                          .remarks = {}};
    const CuraStack cura(file);
    EXPECT_FALSE(cura.number("top_bottom_pattern_0"));
    EXPECT_FALSE(cura.number("infill_line_width"));
    EXPECT_EQ(cura.number("speed_wall_x"), 50); // twice the half
    const SlicerFile printer = cura_printer(file);
    EXPECT_EQ(value(printer, "speed_wall_x"), "50");
    EXPECT_EQ(value(printer, "machine_max_feedrate_x"), "-") << "the speed of light is no limit";
}

TEST(Cura, DefinitionsThatInheritFromThemselvesAreRefused) {
    const test::Folder folder;
    (void)folder.write("a.def.json", definition("b", R"("machine_width": {"value": 3})"));
    (void)folder.write("b.def.json", definition("a", R"("machine_depth": {"value": 3})"));
    const std::string path = folder("a.def.json");
    EXPECT_THROW(cura_file(content_of(path), path), Error);
}

TEST(Cura, DamagedFilesAreReadOrRefused) {
    const std::string whole[] = {
        profile("layer_height = 0.2\nspeed_print = =3\n"), as_comments(profile("line_width = 1\n")),
        definition("", R"("machine_width": {"value": 3})"), archive::zipped({{"a", profile("layer_height = 0.2\n")}})};
    std::mt19937 random(5);
    for (int k = 0; k < 400; ++k)
        for (std::string bytes : whole) {
            for (int n = 0; n < 3; ++n) bytes[random() % bytes.size()] = static_cast<char>(random());
            bytes.resize(bytes.size() - random() % 2 * (random() % bytes.size()));
            try {
                if (auto file = cura_file(bytes, "x")) {
                    const SlicerFile all = merged({*std::move(file)}).front();
                    (void)wishes(all, [](std::string_view) { return true; });
                    (void)cura_printer(all);
                }
            } catch (const Error&) { // it is refused
            }
        }
}

} // namespace
} // namespace filum::app::filum
