// Settings of slicers as variables, and the parts of programs that a profile writes.
#include "preset/program.hpp"
#include "preset/start_code.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using namespace filum;
using Lines = std::vector<std::string>;

preset::Preset of_lines(const std::vector<std::pair<std::string, std::string>>& lines,
                        const std::string& slicer = "prusa") {
    preset::Preset out;
    out.slicer = slicer;
    for (const auto& [key, value] : lines) out.settings[key] = preset::values_of_line(key, value);
    return out;
}

std::string start_of(std::vector<std::pair<std::string, std::string>> lines, preset::Job job = {}) {
    lines.insert(lines.begin(), {{"gcode_flavor", "marlin2"},
                                 {"machine_limits_usage", "ignore"},
                                 {"use_relative_e_distances", "1"},
                                 {"first_layer_temperature", "212"},
                                 {"first_layer_bed_temperature", "58"}});
    return preset::Program(of_lines(lines), std::move(job)).start();
}

std::string wrong(const std::vector<std::pair<std::string, std::string>>& lines) {
    try {
        return "no error: " + start_of(lines);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
}

TEST(Settings, LinesArePartedByTheirType) {
    using preset::values_of_line;
    EXPECT_EQ(values_of_line("temperature", "210, 220"), (Lines{"210", "220"}));
    EXPECT_EQ(values_of_line("filament_type", "PLA;\"a;b\";\"c\\nd\""), (Lines{"PLA", "a;b", "c\nd"}));
    EXPECT_EQ(values_of_line("start_gcode", "G28\\nG1 X1, Y2 ; \\\\"), (Lines{"G28\nG1 X1, Y2 ; \\"}));
    EXPECT_EQ(values_of_line("start_filament_gcode", "\"M900 K1 ; \\\"x\\\"\\nM1\""), (Lines{"M900 K1 ; \"x\"\nM1"}));
    EXPECT_EQ(values_of_line("bed_shape", "0x0,10x0"), (Lines{"0x0", "10x0"}));
    EXPECT_EQ(values_of_line("new_key", "1,2.5"), (Lines{"1", "2.5"}));
    EXPECT_EQ(values_of_line("new_text", "a, b"), (Lines{"a, b"}));
    EXPECT_EQ(preset::values_of_json("machine_start_gcode", "G28\nG1 X1,2"), (Lines{"G28\nG1 X1,2"}));
}

TEST(Settings, PercentagesAndFilamentsOwnValues) {
    const preset::Settings s(of_lines({{"perimeter_speed", "40"},
                                       {"external_perimeter_speed", "50%"},
                                       {"solid_infill_speed", "80"},
                                       {"top_solid_infill_speed", "25%"},
                                       {"extrusion_width", "0"},
                                       {"nozzle_diameter", "0.6"},
                                       {"retract_length", "0.8"},
                                       {"filament_retract_length", "3.2"},
                                       {"retract_lift", "0.2"},
                                       {"filament_retract_lift", "nil"}}));
    EXPECT_DOUBLE_EQ(s.number("external_perimeter_speed"), 20);
    EXPECT_EQ(s.find("external_perimeter_speed")->written[0], "50%");
    EXPECT_DOUBLE_EQ(s.number("top_solid_infill_speed"), 20);
    EXPECT_DOUBLE_EQ(s.number("extrusion_width"), 0.675);
    EXPECT_DOUBLE_EQ(s.number("retract_length"), 3.2);
    EXPECT_DOUBLE_EQ(s.number("retract_lift"), 0.2);
}

// Bambu Studio takes a list of numbers without an index as the value of the current extruder; PrusaSlicer refuses it.
TEST(Settings, ListsOfEqualNumbersWithoutAnIndex) {
    const auto start = [](const char* slicer, const char* diameters) {
        return preset::Program(of_lines({{"machine_start_gcode", "; {if nozzle_diameter == 0.2}thin{else}wide{endif}"},
                                         {"start_gcode", "; {if nozzle_diameter == 0.2}thin{else}wide{endif}"},
                                         {"gcode_flavor", "marlin2"},
                                         {"nozzle_diameter", diameters},
                                         {"printable_area", "0x0,256x0,256x256,0x256"}},
                                        slicer),
                               {})
            .start();
    };
    EXPECT_NE(start("orca", "0.2,0.2").find("; thin"), std::string::npos);
    EXPECT_NE(start("orca", "0.4").find("; wide"), std::string::npos);
    EXPECT_THROW(start("orca", "0.2,0.4"), Error);
    EXPECT_THROW(start("prusa", "0.2,0.2"), Error);
}

// As newer versions of Bambu Studio compute them; is_extruder_used has 64 values there and in OrcaSlicer.
TEST(Settings, FlushingAndUnusedExtruders) {
    preset::Preset bambu;
    bambu.slicer = "bambu";
    bambu.settings = {{"machine_start_gcode",
                       {"; {flush_volumetric_speeds[0]/2} {flush_volumetric_speeds[1]} {flush_temperatures[0]} "
                        "{flush_temperatures[1]}{if long_retraction_when_ec} {retraction_distance_when_ec}{endif}\n; "
                        "{is_extruder_used[0]} {is_extruder_used[1]} {is_extruder_used[7]}"}},
                      {"gcode_flavor", {"marlin2"}},
                      {"nozzle_diameter", {"0.4"}},
                      {"filament_flush_volumetric_speed", {"0", "9.5"}},
                      {"filament_max_volumetric_speed", {"21", "12"}},
                      {"filament_flush_temp", {"0", "250"}},
                      {"nozzle_temperature_range_high", {"240", "260"}},
                      {"long_retractions_when_ec", {"1"}},
                      {"retraction_distances_when_ec", {"8"}},
                      {"printable_area", {"0x0", "256x0", "256x256", "0x256"}}};
    preset::Job job;
    job.tools = {0};
    const std::string start = preset::Program(bambu, job).start();
    EXPECT_NE(start.find("; 10.5 9.5 240 250 8\n; true false false\n"), std::string::npos) << start;
}

TEST(PresetProgram, HeatsOnlyWhereTheStartDoesNot) {
    EXPECT_EQ(
        start_of({{"start_gcode", "G28"}}),
        "M107\nM190 S58 ; set bed temperature and wait for it to be reached\nM104 S212 ; set temperature\n"
        ";TYPE:Custom\nG28\nM109 S212 ; set temperature and wait for it to be reached\n"
        "G21 ; set units to millimeters\nG90 ; use absolute coordinates\nM83 ; use relative distances for extrusion\n");
    EXPECT_EQ(start_of({{"start_gcode", "M140 S60\\n  M109 S[first_layer_temperature] T0"}}).find("; set t"),
              std::string::npos);
    EXPECT_NE(start_of({{"start_gcode", "; M104 S1"}}).find("M104 S212"), std::string::npos);
    const std::string cold = start_of({{"start_gcode", "G28"}, {"first_layer_bed_temperature", "0"}});
    EXPECT_TRUE(cold.find("M190") == std::string::npos && cold.find("M140") == std::string::npos) << cold;
    EXPECT_NE(start_of({}).find(";TYPE:Custom\nG28 ; home all axes\nG1 Z5 F5000 ; lift nozzle\n"), std::string::npos);
    EXPECT_EQ(start_of({{"start_gcode", ""}}).find("G28"), std::string::npos); // none is wanted
    const auto g10 = preset::temperature_commands("G10 P0 R0\nG10 P0 S200 R1", 104, 109, true);
    EXPECT_TRUE(g10.any);
    EXPECT_EQ(g10.celsius, 200);
    EXPECT_FALSE(preset::temperature_commands("G10 P0 R0\nM1040 S5\nXM104 S1", 104, 109, true).any);
}

TEST(PresetProgram, SeveralTools) {
    preset::Job job;
    job.tools = {0, 1};
    job.first_tool = 1;
    const std::string text = start_of({{"start_gcode", "G28 T[initial_tool]"},
                                       {"nozzle_diameter", "0.4,0.4"},
                                       {"first_layer_temperature", "200,210"},
                                       {"start_filament_gcode", "\"; first\";\"; second [filament_extruder_id]\""}},
                                      job);
    EXPECT_NE(text.find("M104 S200 T0 ; set temperature\nM104 S210 T1"), std::string::npos) << text;
    EXPECT_NE(text.find("T1\n; second 1\n"), std::string::npos) << text;
    preset::Program program(
        of_lines({{"gcode_flavor", "marlin"},
                  {"toolchange_gcode", "G1 X0 ; {previous_extruder} to {next_extruder}\nT{next_extruder}"},
                  {"end_filament_gcode", "\"; leave\";\"; leave too\""}}),
        job);
    (void)program.start();
    EXPECT_EQ(program.change_tool(0, 3, 0.8), "; leave too\nG1 X0 ; 1 to 0\nT0\n");
}

TEST(PresetProgram, RefusesWhatItCannotWrite) {
    EXPECT_NE(wrong({{"gcode_flavor", "sailfish"}}).find("'sailfish': Filum writes no programs for it"),
              std::string::npos);
    EXPECT_NE(wrong({{"gcode_flavor", "other"}}).find("Filum does not know it"), std::string::npos);
    EXPECT_NE(wrong({{"start_gcode", "G28\\nM104 S[nozzle_heat]"}})
                  .find("cannot use start_gcode: line 2, column 7: 'nozzle_heat' is no known name"),
              std::string::npos);
    EXPECT_NE(wrong({{"start_filament_gcode", "\"{if 1}\""}}).find("start_filament_gcode"), std::string::npos);
}

TEST(PresetProgram, NamesOfOrcaSlicer) {
    preset::Preset orca;
    orca.slicer = "orca";
    orca.settings = {{"machine_start_gcode",
                      {"M190 S[bed_temperature_initial_layer_single]\nM109 S[nozzle_temperature_initial_layer]\n"
                       "G1 X{first_layer_center_no_wipe_tower[0]} Z{max_layer_z}"}},
                     {"gcode_flavor", {"marlin2"}},
                     {"emit_machine_limits_to_gcode", {"1"}},
                     {"machine_max_speed_x", {"500", "200"}},
                     {"machine_max_acceleration_x", {"9000", "8000"}},
                     {"curr_bed_type", {"Textured PEI Plate"}},
                     {"textured_plate_temp_initial_layer", {"65"}},
                     {"textured_plate_temp", {"60"}},
                     {"nozzle_temperature_initial_layer", {"220"}},
                     {"use_relative_e_distances", {"1"}},
                     {"printable_area", {"0x0", "256x0", "256x256", "0x256"}}};
    preset::Job job;
    job.first_layer = {{100, 100}, {120, 100}, {120, 110}};
    job.height = 12.4;
    const std::string start = preset::Program(orca, job).start();
    EXPECT_TRUE(start.starts_with("M201 X9000 ")) << start;
    EXPECT_NE(start.find("M203 X500 "), std::string::npos) << start;
    EXPECT_NE(preset::Program(orca, job).start().find("M190 S65\nM109 S220\nG1 X110 Z12.4\n"), std::string::npos)
        << preset::Program(orca, job).start();
}

// The names of Bambu Studio 2, on a printer with two nozzles whose second one is called the first.
TEST(PresetProgram, NamesOfBambuStudio) {
    preset::Preset bambu;
    bambu.slicer = "orca";
    bambu.settings = {
        {"machine_start_gcode",
         {"; {first_filaments[0]} {first_filaments[1]} {first_tools[0]} {first_non_support_tools[1]} "
          "{curr_physical_extruder_id}\n; {max_print_z} {min_vitrification_temperature} {is_all_bbl_filament} "
          "{has_tpu_in_first_layer} {has_timelapse_safe_pos} {timelapse_pos_x}\n; "
          "{nozzle_temperature_initial_layer[first_filaments[0]]}\n; {initial_filament_id} {initial_nozzle_id} "
          "{nozzle_diameter_at_nozzle_id[initial_nozzle_id]} {current_hotend} {first_non_support_hotend[1]} "
          "{max_additional_fan} {curr_y_acceleration_limit} {if long_retraction_when_cut}cut{endif} "
          "{filament_ids[initial_filament_id]}\nM190 S50\nM109 S220"}},
        {"gcode_flavor", {"marlin2"}},
        {"nozzle_diameter", {"0.4", "0.6"}},
        {"additional_cooling_fan_speed", {"70", "30"}},
        {"machine_max_acceleration_y", {"12000"}},
        {"long_retractions_when_cut", {"0", "1"}},
        {"filament_id", {"GFA00", "GFA01"}},
        {"machine_max_force_Y", {"10"}},
        {"machine_bed_mass_Y", {"2000"}},
        {"filament_density", {"1.25", "1.25"}},
        {"physical_extruder_map", {"1", "0"}},
        {"filament_map", {"1", "2"}},
        {"filament_vendor", {"Bambu Lab", "Other"}},
        {"filament_type", {"PLA", "TPU"}},
        {"temperature_vitrification", {"45", "30"}},
        {"nozzle_temperature_initial_layer", {"220", "230"}},
        {"printable_area", {"0x0", "256x0", "256x256", "0x256"}}};
    preset::Job job;
    job.first_layer = {{100, 100}, {120, 100}, {120, 110}};
    job.height = 12.4;
    job.tools = {0};
    job.volume = {{0U, 400'000}}; // 500 g
    std::string start = preset::Program(bambu, job).start();
    EXPECT_NE(start.find("; -1 0 -1 0 1\n; 13 45 true false false 0\n; 220\n; 0 0 0.4 -1 -1 70 4000  GFA00\n"),
              std::string::npos)
        << start;
    job.tools = {1};
    job.first_tool = 1;
    start = preset::Program(bambu, job).start();
    EXPECT_NE(start.find("; 1 -1 1 -1 0\n; 13 30 false true false 0\n; 230\n; 1 1 0.6 -1 -1 30 4000 cut GFA01\n"),
              std::string::npos)
        << start;
}

// A print of one layer keeps the chamber warm if it is larger than a square of 200 mm, on large beds than one that is
// 70 mm smaller than the bed.
TEST(PresetProgram, LargeFlatPrintsOfBambuStudio) {
    for (const double bed : {200.0, 256.0, 260.0, 300.0, 400.0})
        for (const double share : {0.9, 1.1})
            for (const double height : {0.2, 0.4}) {
                preset::Preset bambu;
                bambu.slicer = "bambu";
                const std::string far = std::to_string(bed);
                bambu.settings = {{"machine_start_gcode",
                                   {"; {hold_chamber_temp_for_flat_print} {wipe_tower_center_pos_valid} "
                                    "{wipe_tower_center_pos_x}\nM190 S50\nM109 S220"}},
                                  {"gcode_flavor", {"marlin2"}},
                                  {"nozzle_diameter", {"0.4"}},
                                  {"initial_layer_print_height", {"0.2"}},
                                  {"printable_area", {"0x0", far + "x0", far + "x" + far, "0x" + far}}};
                preset::Job job;
                job.height = height;
                const double side = bed > 260 ? bed - 70 : 200;
                job.volume = {{0U, share * side * side * height}};
                const bool flat = height < 0.3 && share > 1;
                const std::string start = preset::Program(bambu, job).start();
                EXPECT_NE(start.find(std::string(flat ? "; true" : "; false") + " false 0\n"), std::string::npos)
                    << start << bed << " " << share << " " << height;
            }
}

} // namespace
