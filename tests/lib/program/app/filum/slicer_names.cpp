#include "app/filum/slicer_names.hpp"

#include "../files.hpp"
#include "base/error.hpp"
#include "machine/profile.hpp"

namespace filum::app::filum {
namespace {

using Words = std::vector<std::string>;

std::vector<Stage> some_stages() {
    const auto stage = [](const char* name, std::initializer_list<const char*> options) {
        Stage s;
        s.name = name;
        for (const char* o : options) s.options.push_back({o, std::string(o) != "support"});
        return s;
    };
    return {
        stage("slice", {"scale", "rotate", "layer-height", "copies", "xy-compensation", "elephant-foot", "shrinkage"}),
        stage("skins", {"infill", "infill-pattern", "walls", "top", "bottom", "bead-width", "solid-below"}),
        stage("supports", {"support", "support-angle", "support-on", "brim", "skirt"}),
        stage("postproc", {"set", "machine", "z-offset"})};
}

Words ours(const Words& theirs) { return translated(theirs, some_stages()).words; }

TEST(SlicerNames, OptionsByTheirNamesWork) {
    EXPECT_EQ(ours({"--fill-density", "15%"}), Words{"--infill=15%"});
    EXPECT_EQ(ours({"--fill_density=20"}), Words{"--infill=20%"});
    EXPECT_EQ(ours({"--nozzle-diameter", "0.6", "p.stl"}), (Words{"--bead-width=0.6", "p.stl"}));
    EXPECT_EQ(ours({"--rotate", "45"}), Words{"--rotate=0,0,45"});
    EXPECT_EQ(ours({"--rotate", "1,2,3"}), Words{"--rotate=1,2,3"});
    EXPECT_EQ(ours({"--rotate-x=90"}), Words{"--rotate=90,0,0"});
    EXPECT_EQ(ours({"--scale", "150%"}), Words{"--scale=1.5"});
    EXPECT_EQ(ours({"--scale", "2"}), Words{"--scale=2"});
    EXPECT_EQ(ours({"--support-material", "--support-material-threshold", "40"}),
              (Words{"--support", "--support-angle=50"}));
    EXPECT_EQ(ours({"--fill-pattern", "gyroid"}), Words{"--infill-pattern=wave"});
    EXPECT_EQ(ours({"--fill-pattern", "concentric"}), Words{"--infill-pattern=concentric"});
}

TEST(SlicerNames, AllKeysOfTheMachineAreOneOption) {
    EXPECT_EQ(ours({"--temperature", "210", "p.stl", "--set", "feeds.bead=40", "--bed-temperature=50"}),
              (Words{"--set=nozzle_temp=210,feeds.bead=40,bed_temp=50", "p.stl"}));
}

TEST(SlicerNames, CompensationAndCopiesHaveOtherNames) {
    EXPECT_EQ(ours({"--duplicate", "3", "p.stl"}), (Words{"--copies=3", "p.stl"}));
    const test::Folder at;
    const std::string file = at.write("x.ini", "xy_size_compensation = -0.1\nelefant_foot_compensation = 0.2\n"
                                               "z_offset = -0.05\n");
    EXPECT_EQ(ours({"--load", file}), (Words{"--xy-compensation=-0.1", "--elephant-foot=0.2", "--z-offset=-0.05"}));
    const std::string none = at.write("y.ini", "xy_size_compensation = 0\nz_offset = 0\nlayer_height = 0.2\n");
    EXPECT_EQ(ours({"--load", none}), Words{"--layer-height=0.2"});
}

// Supports only where a body asks for them: the angle has no meaning then, the place where columns stand has.
TEST(SlicerNames, SupportsByHandNeedNoAngle) {
    const test::Folder at;
    const std::string file =
        at.write("x.ini", "support_material = 1\nsupport_material_auto = 0\n"
                          "support_material_threshold = 30\nsupport_material_buildplate_only = 1\n");
    const auto words = [&](const Words& typed) {
        Words all = typed;
        all.insert(all.end(), {"--load", file});
        return ours(all);
    };
    EXPECT_EQ(words({}), Words{});
    EXPECT_EQ(words({"--support-in=e.stl"}), (Words{"--support-on=bed", "--support-in=e.stl"}));
    EXPECT_EQ(words({"--raft=2"}), Words{"--raft=2"});
    EXPECT_EQ(words({"--support"}), (Words{"--support-angle=60", "--support-on=bed", "--support"}));
}

// PrusaSlicer says what is lost in z, OrcaSlicer what is left.
TEST(SlicerNames, ShrinkageOfAllAxesIsOneOption) {
    const test::Folder at;
    const auto load = [&](const char* text) { return ours({"--load", at.write("s.ini", text)}); };
    const std::string xy = "filament_shrinkage_compensation_xy", z = "\nfilament_shrinkage_compensation_z";
    EXPECT_EQ(load((xy + " = 0.8%" + z + " = 0.3%\n").c_str()), Words{"--shrinkage=0.8,0.8,0.3"});
    EXPECT_EQ(load((z + " = 0.3%\n" + xy + " = 0.8%\n").c_str()), Words{"--shrinkage=0.8,0.8,0.3"});
    EXPECT_EQ(load((z + " = 99.5%\n").c_str()), Words{"--shrinkage=0,0,0.5"});
    EXPECT_EQ(load(("layer_height = 0.2" + z + " = 100%\n").c_str()), Words{"--layer-height=0.2"});
    EXPECT_EQ(load(("layer_height = 0.2" + z + " = 0%\n").c_str()), Words{"--layer-height=0.2"});
}

TEST(SlicerNames, OwnWordsStay) {
    const Words words{"--walls", "3", "--unknown", "-o", "x.gcode", "p.stl", "--", "--temperature", "--set=x"};
    EXPECT_EQ(ours(words), words);
}

TEST(SlicerNames, RefusesWhatDoesNotFit) {
    for (const Words& wrong : {Words{"--temperature"}, Words{"--temperature", "hot"}, Words{"--fill-pattern", "stars"},
                               Words{"--scale", "x%"}, Words{"--load"}, Words{"--load", "/nowhere/x.ini"}})
        EXPECT_THROW(ours(wrong), Error) << wrong[0];
}

TEST(SlicerNames, AFileGivesWhatHasAMeaningAndTellsTheRest) {
    const test::Folder at;
    const std::string file = at.write("x.ini", "# generated\nlayer_height = 0.3\nfill_density = 25%\nperimeters = 3\n"
                                               "nozzle_diameter = 0.4,0.6\nextrusion_width = 0.45\nraft_layers = 0\n"
                                               "ironing = 1\ntemperature = 230\nskirts = 0\nskirt_distance = 6\n"
                                               "support_material = 0\nsupport_material_threshold = 40\n"
                                               "default_speed = 60\nperimeter_speed = 80%\nfill_pattern = honeycomb\n");
    const SlicerTranslation t = translated({"--walls", "4", "--load", file, "--temperature", "200"}, some_stages());
    EXPECT_EQ(t.words, (Words{"--layer-height=0.3", "--infill=25%", "--walls=3", "--bead-width=0.45",
                              "--set=nozzle_temp=230,feeds.wall=48,nozzle_temp=200", "--walls", "4"}));
    EXPECT_EQ(t.left, (Words{"ironing", "fill_pattern"}));
    EXPECT_TRUE(t.harmful.empty());
    EXPECT_THROW(translated({"--load", at.write("empty.ini", "\n# nothing\n")}, some_stages()), Error);
}

// The words for a file of settings.
Words loaded(const std::string& text, const std::string& name = "x.ini") {
    const test::Folder at;
    std::vector<Stage> stages = some_stages();
    for (const char* o : {"hole-compensation", "first-layer-height"}) stages[0].options.push_back({o, true});
    return translated({"--load", at.write(name, text)}, stages).words;
}

TEST(SlicerSettings, ZeroIsZero) {
    EXPECT_EQ(loaded("fill_density = 0%\nperimeters = 2\ntop_solid_layers = 0\nbottom_solid_layers = 3\n"),
              (Words{"--infill=0%", "--walls=2", "--top=0", "--bottom=3"}));
    EXPECT_EQ(loaded("retract_length = 0\nretract_lift = 0\nbed_temperature = 0\nperimeter_speed = 0\n"),
              Words{"--set=travel.retract=0,travel.lift=0,bed_temp=0"}); // a speed of 0 is chosen by the slicer
}

TEST(SlicerSettings, DensitiesAreSharesInOldFiles) {
    for (const auto& [text, want] : {std::pair{"0.25", "25%"},
                                     {"25%", "25%"},
                                     {"40", "40%"},
                                     {"1", "100%"},
                                     {"0.4%", "0.4%"},
                                     {"0", "0%"},
                                     {"1%", "1%"}})
        EXPECT_EQ(loaded("fill_density = " + std::string(text) + "\n"), Words{std::string("--infill=") + want}) << text;
    EXPECT_EQ(loaded(R"({"sparse_infill_density": "1"})"), Words{"--infill=1%"}); // OrcaSlicer has no shares
}

TEST(SlicerSettings, WidthsArePercentOfWhatTheirSlicerSays) {
    const std::string text = "layer_height = 0.2\nnozzle_diameter = 0.6\nextrusion_width = ";
    const auto width = [&](const std::string& head, const std::string& value) {
        return loaded(head + text + value + "\n").back();
    };
    EXPECT_EQ(width("# generated by SuperSlicer 2.5.59\n", "110%"), "--bead-width=0.66");
    EXPECT_EQ(width("# generated by PrusaSlicer 2.5.0\n", "110%"), "--bead-width=0.6");
    EXPECT_EQ(width("# generated by PrusaSlicer 2.5.0\n", "400%"), "--bead-width=0.8");
    EXPECT_EQ(width("", "110%"), "--bead-width=0.66");
    EXPECT_EQ(width("", "0.5"), "--bead-width=0.5");
    EXPECT_EQ(width("", "0"), "--bead-width=0.6");
    EXPECT_EQ(loaded(R"({"line_width": "105%", "nozzle_diameter": ["0.4", "0.4"]})"), Words{"--bead-width=0.42"});
}

TEST(SlicerSettings, HolesStayWhereOrcaLeavesThem) {
    EXPECT_EQ(loaded(R"({"xy_contour_compensation": "0.2", "xy_hole_compensation": "0.1"})"),
              (Words{"--xy-compensation=0.2", "--hole-compensation=0.3"}));
    EXPECT_EQ(loaded(R"({"xy_hole_compensation": "0.1"})"), Words{"--hole-compensation=0.1"});
    EXPECT_EQ(loaded("xy_size_compensation = 0.2\n"), Words{"--xy-compensation=0.2"});
    EXPECT_EQ(loaded("# generated by SuperSlicer\nxy_size_compensation = 0.2\nxy_inner_size_compensation = 0.2\n"),
              Words{"--xy-compensation=0.2"});
}

TEST(SlicerSettings, BrimsAreOfTheirType) {
    EXPECT_EQ(loaded(R"({"brim_width": "5"})"), Words{}); // OrcaSlicer's is automatic
    EXPECT_EQ(loaded(R"({"brim_width": "5", "brim_type": "outer_only"})"), Words{"--brim=5"});
    EXPECT_EQ(loaded("brim_width = 5\n"), Words{"--brim=5"});
    EXPECT_EQ(loaded("brim_width = 5\nbrim_type = no_brim\n"), Words{});
    EXPECT_EQ(loaded("brim_width = 5\nbrim_type = inner_only\n"), Words{});
}

TEST(SlicerSettings, SpeedsArePercentOfOtherSpeeds) {
    EXPECT_EQ(loaded("infill_speed = 100\nsolid_infill_speed = 50%\ntop_solid_infill_speed = 40%\n"),
              Words{"--set=feeds.infill=100,feeds.solid=50,feeds.bead=50,feeds.top=20"});
    EXPECT_EQ(loaded("external_perimeter_speed = 50%\n"), Words{"--set=feeds.outer_wall=30"}); // of its default
}

TEST(SlicerSettings, ShellsAreAsThickAsTheyMustBe) {
    EXPECT_EQ(loaded("layer_height = 0.1\ntop_solid_layers = 5\ntop_solid_min_thickness = 0.7\n"),
              (Words{"--layer-height=0.1", "--top=7"}));
    EXPECT_EQ(loaded("layer_height = 0.2\nbottom_solid_layers = 4\nbottom_solid_min_thickness = 0.5\n"),
              (Words{"--layer-height=0.2", "--bottom=4"}));
    EXPECT_EQ(loaded("layer_height = 0.2\ntop_solid_layers = 0\ntop_solid_min_thickness = 0.7\n"),
              (Words{"--layer-height=0.2", "--top=0"}));
    EXPECT_EQ(loaded(R"({"layer_height": "0.2", "top_shell_layers": "3", "top_shell_thickness": "0.8"})"),
              (Words{"--layer-height=0.2", "--top=4"}));
}

TEST(SlicerSettings, TheFanGoesByTheTimeOfALayer) {
    EXPECT_EQ(loaded("max_fan_speed = 80\nmin_fan_speed = 40\nfan_always_on = 1\nfan_below_layer_time = 100\n"
                     "slowdown_below_layer_time = 15\ndisable_fan_first_layers = 1\nbridge_fan_speed = 100\n"),
              Words{"--set=limits.layer_time=15,cooling.most=204,cooling.least=102,cooling.idle=102,cooling.fast=15,"
                    "cooling.below=100,"
                    "cooling.off_layers=1,cooling.full_layer=0,cooling.bridge=255"});
    const std::string still = loaded("max_fan_speed = 80\ncooling = 0\n").at(0); // no fan by time, none always
    EXPECT_NE(still.find("cooling.idle=0,cooling.fast=0,cooling.below=0"), std::string::npos) << still;
    const std::string orca = loaded(R"({"fan_max_speed": ["60"], "overhang_fan_speed": ["90"]})").at(0);
    EXPECT_NE(orca.find("cooling.most=153,cooling.least=51,cooling.idle=0"), std::string::npos) << orca;
    EXPECT_NE(orca.find("cooling.bridge=229.5"), std::string::npos) << orca;
}

TEST(SlicerSettings, AnAccelerationOfZeroIsThatOfEverythingElse) {
    EXPECT_EQ(loaded("perimeter_acceleration = 0\ninfill_acceleration = 0\ndefault_acceleration = 0\n"), Words{});
    EXPECT_EQ(
        loaded("perimeter_acceleration = 800\nexternal_perimeter_acceleration = 0\ninfill_acceleration = 0\n"
               "solid_infill_acceleration = 900\ntop_solid_infill_acceleration = 0\ndefault_acceleration = 1000\n"),
        Words{"--set=features.wall.acceleration=800,features.outer_wall.acceleration=800,"
              "features.infill.acceleration=1000,features.solid.acceleration=900,features.top.acceleration=900,"
              "motion.acceleration=1000"});
    EXPECT_EQ(loaded("perimeter_acceleration = 800\ninfill_acceleration = 700\n"), // of PrusaSlicer 2.5
              Words{"--set=features.wall.acceleration=800,features.outer_wall.acceleration=800,"
                    "features.infill.acceleration=700,features.solid.acceleration=700,features.top.acceleration=700"});
    EXPECT_EQ(loaded(R"({"default_acceleration": "5000", "sparse_infill_acceleration": "50%"})"),
              Words{"--set=motion.acceleration=5000,features.infill.acceleration=2500"});
}

TEST(SlicerSettings, AListHasAnItemForEachExtruder) {
    EXPECT_EQ(loaded("temperature = 200,230\n"), Words{"--set=nozzle_temp=200"});
    EXPECT_EQ(loaded("temperature = 200,230\nperimeter_extruder = 2\n"), Words{"--set=nozzle_temp=230"});
    EXPECT_EQ(loaded("retract_length = 2\nfilament_retract_length = nil\n"), Words{"--set=travel.retract=2"});
    EXPECT_EQ(loaded("retract_length = 2\nfilament_retract_length = 0.5\n"), Words{"--set=travel.retract=0.5"});
}

TEST(SlicerSettings, ProgramsKeepSettingsInTheirComments) {
    const std::string prusa =
        "; generated by PrusaSlicer 2.6.0 on 2024\n\nG28\nG1 X1 ; x = 2\n; filament used [mm] = 3\n"
        "; prusaslicer_config = begin\n; perimeters = 4\n; fill_density = 12%\n"
        "; prusaslicer_config = end\n; layer_height = 9\n";
    EXPECT_EQ(loaded(prusa, "x.gcode"), (Words{"--walls=4", "--infill=12%"}));
    const std::string orca = "; HEADER_BLOCK_START\n; generated by OrcaSlicer 2.0\n; HEADER_BLOCK_END\n"
                             "; CONFIG_BLOCK_START\n; wall_loops = 3\n; brim_width = 5\n; CONFIG_BLOCK_END\nG28\n";
    EXPECT_EQ(loaded(orca, "x.gcode"), Words{"--walls=3"});
    EXPECT_EQ(loaded("; generated by Slic3r 1.3.0\nG28\n; perimeters = 4\n; total cost = 3\n", "x.gcode"),
              Words{"--walls=4"});
    EXPECT_THROW(loaded("; generated by Cura\nG28\n", "x.gcode"), Error);
    EXPECT_THROW(loaded("GCDE....", "x.bgcode"), Error);
    EXPECT_THROW(loaded("[print:0.2mm]\nperimeters = 3\n[printer:MK3]\n"), Error);
}

TEST(SlicerSettings, WhatCanDoHarmIsNamedApart) {
    const test::Folder at;
    const SlicerTranslation t = translated(
        {"--load",
         at.write("x.ini",
                  "start_gcode = G28\\nG1 Z5\nend_gcode = ; nothing\\n\nbed_exclude_area = 0x0,18x0,18x28,0x28\n"
                  "complete_objects = 0\nthreads = 4\nironing = 1\nnew_key = 3\n")},
        some_stages());
    EXPECT_EQ(t.harmful, (Words{"bed_exclude_area"}));
    EXPECT_EQ(t.left, (Words{"ironing", "new_key"}));
}

TEST(SlicerSettings, AWipeIsAsLongAsItsRetraction) {
    EXPECT_EQ(loaded("; generated by PrusaSlicer 2.5.0\nwipe = 1\nretract_length = 2\nretract_speed = 40\n"
                     "travel_speed = 100\nretract_before_wipe = 50%\n"),
              Words{"--set=travel.wipe=1.9,travel.before_wipe=0.5,travel.retract=2,travel.retract_speed=40,"
                    "feeds.travel=100"}); // 0.95 * 1 mm / 40 mm/s * 80 mm/s
    EXPECT_EQ(loaded("; generated by PrusaSlicer 2.5.0\nwipe = 0\nretract_length = 2\n"),
              Words{"--set=travel.retract=2"});
    EXPECT_EQ(loaded("; generated by PrusaSlicer 2.5.0\nmax_volumetric_speed = 8\nfilament_max_volumetric_speed = 0\n"),
              Words{"--set=limits.flow=8"});
    EXPECT_EQ(loaded("first_layer_acceleration = 0\nmin_print_speed = 12\n"), Words{"--set=limits.least_feed=12"});
    const std::string prusa = "; generated by PrusaSlicer 2.6.0\n";
    EXPECT_EQ(loaded(prusa + "first_layer_speed = 40%\n"), Words{"--set=feeds.first_layer_share=0.4"});
    EXPECT_EQ(loaded(prusa + "first_layer_speed = 25\n"),
              Words{"--set=feeds.first_layer=25,feeds.first_layer_exact=true"});
    EXPECT_EQ(loaded("; generated by SuperSlicer 2.5.59\nfirst_layer_speed = 25\n"),
              Words{"--set=feeds.first_layer=25"});
    EXPECT_EQ(loaded(prusa + "enable_dynamic_overhang_speeds = 0\noverhang_speed_0 = 10\n"), Words{});
}

TEST(SlicerMachine, ThePrinterOfAFileIsTheMachine) {
    const test::Folder at;
    const std::string file = at.write("x.ini", "start_gcode = G28\\nM104 S[temperature]\ntemperature = 215\n"
                                               "bed_shape = -90x-80,90x-80,90x80,-90x80\nmax_print_height = 120\n");
    const SlicerTranslation t = translated({"--load", file, "--temperature", "230"}, some_stages());
    ASSERT_NE(t.machine, nullptr);
    EXPECT_EQ(t.words.front(), "--machine=" + t.machine->path());
    EXPECT_EQ(t.words.back(), "--set=nozzle_temp=230"); // not that of the file: its G-code heats
    EXPECT_EQ(t.machine->command(), "filum settings --machine " + file + " > ./slicer-machine.toml\n");
    const auto profile = machine::parse_profile(t.machine->text(), "x.toml");
    EXPECT_EQ(profile.bed.x_min, -90);
    EXPECT_EQ(profile.bed.y_max, 80);
    EXPECT_EQ(profile.bed.z_max, 120);
    EXPECT_FALSE(profile.extrusion.relative);
    ASSERT_NE(profile.preset, nullptr);
    EXPECT_EQ(profile.preset->settings.at("start_gcode"), Words{"G28\nM104 S[temperature]"});
    EXPECT_EQ(translated({"--load", file, "--machine", "klipper"}, some_stages()).machine, nullptr);
    const std::string wrong = at.write("y.ini", "start_gcode = G28\\n{if 1}\n");
    EXPECT_THROW(translated({"--load", wrong}, some_stages()), Error);
}

} // namespace
} // namespace filum::app::filum
