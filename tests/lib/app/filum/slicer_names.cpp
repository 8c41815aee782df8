#include "app/filum/slicer_names.hpp"

#include "../files.hpp"
#include "base/error.hpp"

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
    EXPECT_EQ(ours({"--nozzle", "0.6", "p.stl"}), (Words{"--bead-width=0.6", "p.stl"}));
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
    const Words words{"--infill", "15%", "--unknown", "-o", "x.gcode", "p.stl", "--", "--temperature", "--set=x"};
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
                                               "perimeter_speed = 80%\nfill_pattern = honeycomb\n");
    const Translated t = translated({"--walls", "4", "--load", file, "--temperature", "200"}, some_stages());
    EXPECT_EQ(t.words, (Words{"--layer-height=0.3", "--infill=25%", "--walls=3", "--bead-width=0.45",
                              "--set=nozzle_temp=230,nozzle_temp=200", "--walls", "4"}));
    EXPECT_EQ(t.left, (Words{"ironing", "perimeter_speed", "fill_pattern"}));
    EXPECT_THROW(translated({"--load", at.write("empty.ini", "\n# nothing\n")}, some_stages()), Error);
}

} // namespace
} // namespace filum::app::filum
