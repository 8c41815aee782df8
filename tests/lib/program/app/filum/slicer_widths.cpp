#include "app/filum/slicer_widths.hpp"

#include "app/filum/slicer_settings.hpp"

#include <gtest/gtest.h>

namespace filum::app::filum {
namespace {

using Words = std::vector<std::string>;

SlicerFile file(Slicer slicer, std::vector<SlicerSetting> settings) { return {slicer, std::move(settings)}; }

// The options of widths that a file makes.
Words widths(const SlicerFile& from) {
    Words out;
    for (const std::string& word : wishes(from, [](std::string_view) { return true; }).words)
        if (word.find("width=") != std::string::npos) out.push_back(word);
    return out;
}

TEST(SlicerWidths, EveryRoleOfPrusaSlicer) {
    EXPECT_EQ(widths(file(Slicer::prusa, {{"nozzle_diameter", "0.4"},
                                          {"extrusion_width", "0.45"},
                                          {"external_perimeter_extrusion_width", "0.42"},
                                          {"perimeter_extrusion_width", "0.48"},
                                          {"infill_extrusion_width", "0"},
                                          {"solid_infill_extrusion_width", "0.5"},
                                          {"first_layer_extrusion_width", "0.6"},
                                          {"support_material_extrusion_width", "0.35"},
                                          {"support_material", "1"},
                                          {"fill_density", "20%"}})),
              (Words{"--bead-width=0.42", "--inner-width=0.48", "--infill-width=0.45", "--solid-width=0.5",
                     "--first-layer-width=0.6", "--support-width=0.35"}));
}

TEST(SlicerWidths, EveryRoleOfOrcaSlicer) {
    EXPECT_EQ(widths(file(Slicer::orca, {{"inner_wall_line_width", "0.45"},
                                         {"initial_layer_line_width", "0.5"},
                                         {"internal_solid_infill_line_width", "0.42"},
                                         {"line_width", "0.42"},
                                         {"outer_wall_line_width", "0.42"},
                                         {"sparse_infill_density", "15%"},
                                         {"sparse_infill_line_width", "112%"},
                                         {"nozzle_diameter", "0.4"}})),
              (Words{"--inner-width=0.45", "--first-layer-width=0.5", "--solid-width=0.42", "--bead-width=0.42",
                     "--infill-width=0.448"}));
}

TEST(SlicerWidths, ASolidPartHasOneWidthAndTheFirstLayersOwn) {
    EXPECT_EQ(widths(file(Slicer::prusa, {{"external_perimeter_extrusion_width", "0.42"},
                                          {"perimeter_extrusion_width", "0.48"},
                                          {"first_layer_extrusion_width", "0.5"},
                                          {"fill_density", "100%"}})),
              (Words{"--bead-width=0.42", "--first-layer-width=0.5"}));
}

TEST(SlicerWidths, AWidthOfZeroIsChosenAsTheSlicerChoosesIt) {
    const auto chosen = [](Slicer slicer) {
        return widths(file(slicer, {{"extrusion_width", "0"}, {"nozzle_diameter", "0.4"}, {"fill_density", "20%"}}));
    };
    EXPECT_EQ(chosen(Slicer::prusa), Words{"--bead-width=0.45"});
    EXPECT_EQ(chosen(Slicer::unknown), Words{"--bead-width=0.4"});
    // A lone printer says nothing of widths.
    EXPECT_EQ(widths(file(Slicer::prusa, {{"nozzle_diameter", "0.6"}})), Words{"--bead-width=0.6"});
}

TEST(SlicerWidths, PercentagesOfTheFirstLayerAreOfItsHeight) {
    const SlicerFile from = file(Slicer::prusa, {{"nozzle_diameter", "0.4"},
                                                 {"layer_height", "0.2"},
                                                 {"first_layer_height", "0.3"},
                                                 {"extrusion_width", "0.45"},
                                                 {"first_layer_extrusion_width", "200%"}});
    EXPECT_EQ(widths(from), (Words{"--bead-width=0.45", "--first-layer-width=0.6"}));
    const Words remarks = wishes(from, [](std::string_view) { return true; }).remarks;
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("taken of the layer height, as PrusaSlicer does: 0.6 mm"), std::string::npos);
}

TEST(SlicerWidths, AWidthThatCannotBeIsNamed) {
    const Words remarks =
        wishes(file(Slicer::prusa,
                    {{"extrusion_width", "0.45"}, {"fill_density", "20%"}, {"top_infill_extrusion_width", "0.4"}}),
               [](std::string_view) { return true; })
            .remarks;
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("top_infill_extrusion_width = 0.4"), std::string::npos) << remarks[0];
}

} // namespace
} // namespace filum::app::filum
