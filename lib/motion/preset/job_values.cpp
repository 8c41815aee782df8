#include "preset/start_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <numbers>
#include <utility>

namespace filum::preset {

namespace {

using macro::Value;
using macro::Variable;

Value whole_value(double value) { return static_cast<std::int64_t>(std::llround(value)); }

Variable point(double x, double y) { return Variable::many({x, y}); }

struct Extent {
    geom::Vec2 low, high;
};

Extent extent(const std::vector<geom::Vec2>& points) {
    if (points.empty()) return {};
    Extent out{points.front(), points.front()};
    for (const geom::Vec2& p : points) {
        out.low = {std::min(out.low.x, p.x), std::min(out.low.y, p.y)};
        out.high = {std::max(out.high.x, p.x), std::max(out.high.y, p.y)};
    }
    return out;
}

void set_box(const std::string& name, const Extent& box, Settings& to) {
    to.set(name + "_min", point(box.low.x, box.low.y));
    to.set(name + "_max", point(box.high.x, box.high.y));
    to.set(name + "_size", point(box.high.x - box.low.x, box.high.y - box.low.y));
}

std::string two_digits(int value) { return (value < 10 ? "0" : "") + std::to_string(value); }

// Sets the time of writing: job.clock, else SOURCE_DATE_EPOCH, else the current time.
void set_clock(const Job& job, Settings& to) {
    std::time_t now = std::time(nullptr);
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) now = std::strtoll(epoch, nullptr, 10);
    if (job.clock) now = *job.clock;
    std::tm local{};
    if (localtime_r(&now, &local) == nullptr) return;
    const int year = 1900 + local.tm_year, month = 1 + local.tm_mon;
    to.set("timestamp", Variable::one(std::to_string(year) + two_digits(month) + two_digits(local.tm_mday) + "-" +
                                      two_digits(local.tm_hour) + two_digits(local.tm_min) + two_digits(local.tm_sec)));
    const std::pair<const char*, int> parts[] = {{"year", year},           {"month", month},
                                                 {"day", local.tm_mday},   {"hour", local.tm_hour},
                                                 {"minute", local.tm_min}, {"second", local.tm_sec}};
    for (const auto& [name, value] : parts) to.set(name, Variable::one(whole_value(value)));
}

// Sets the material of each extruder, and whether it is used.
// OrcaSlicer and Bambu Studio (`orca`) list 64 extruders, so that macros may ask for any of them.
void set_material(const Job& job, std::size_t extruders, bool orca, Settings& to) {
    std::vector<Value> used, volume, weight;
    double all_volume = 0, all_weight = 0;
    for (std::uint32_t tool = 0; tool < extruders; ++tool) {
        used.emplace_back(std::ranges::find(job.tools, tool) != job.tools.end());
        const auto found = job.volume.find(tool);
        const double mm3 = found == job.volume.end() ? 0 : found->second;
        const double grams = mm3 / 1000 * to.number("filament_density", tool);
        volume.emplace_back(mm3);
        weight.emplace_back(grams);
        all_volume += mm3;
        all_weight += grams;
    }
    constexpr std::size_t kExtrudersOfOrca = 64;
    if (orca && used.size() < kExtrudersOfOrca) used.resize(kExtrudersOfOrca, Value{false});
    to.set("is_extruder_used", Variable::many(used));
    to.set("extruded_volume", Variable::many(volume));
    to.set("extruded_weight", Variable::many(weight));
    to.set("extruded_volume_total", Variable::one(all_volume));
    to.set("extruded_weight_total", Variable::one(all_weight));
    to.set("total_weight", Variable::one(all_weight));
    to.set("num_extruders", Variable::one(whole_value(static_cast<double>(extruders))));
    to.set("num_printing_extruders", Variable::one(whole_value(static_cast<double>(job.tools.size()))));
}

// Sets the flow of the outer wall, mm3/s: a rectangle with round ends, as wide as the setting or the nozzle.
void set_outer_wall(Settings& to) {
    const double nozzle = to.number("nozzle_diameter", 0, 0.4), height = to.number("layer_height", 0, 0.2);
    double width = 0;
    for (const char* key : {"outer_wall_line_width", "line_width"}) {
        if (width > 0) break;
        width = to.number(key);
        if (const Variable* found = to.find(key);
            found != nullptr && !found->written.empty() && found->written[0].ends_with('%'))
            width = width / 100 * nozzle;
    }
    if (!(width > 0)) width = nozzle;
    const double section = height * (width - height * (1 - std::numbers::pi / 4));
    const double most = to.number("filament_max_volumetric_speed");
    double flow = to.number("outer_wall_speed") * section;
    if (most > 0) flow = flow > 0 ? std::min(flow, most) : most;
    to.set("outer_wall_volumetric_speed", Variable::one(flow));
}

// Sets the area that a printer probes, as OrcaSlicer computes it: the first layer and a margin, within the bed's area
// for probing.
void set_bed_mesh(const Extent& box, bool klipper, Settings& to) {
    const auto point_of = [&](const char* name, geom::Vec2 otherwise) {
        const auto found = corners(to.texts(name));
        return found.empty() ? otherwise : found[0];
    };
    constexpr double far = 99999; // mm
    const geom::Vec2 low = point_of("bed_mesh_min", {-far, -far}), high = point_of("bed_mesh_max", {far, far}),
                     apart = point_of("bed_mesh_probe_distance", {50, 50});
    const double margin = to.number("adaptive_bed_mesh_margin");
    const geom::Vec2 from{std::max(low.x, box.low.x - margin), std::max(low.y, box.low.y - margin)},
        end{std::min(high.x, box.high.x + margin), std::min(high.y, box.high.y + margin)};
    to.set("adaptive_bed_mesh_min", point(from.x, from.y));
    to.set("adaptive_bed_mesh_max", point(end.x, end.y));
    const auto count = [](double length, double step) {
        return std::max(3.0, std::ceil(length / std::max(1.0, step)));
    };
    double x = count(end.x - from.x, apart.x), y = count(end.y - from.y, apart.y);
    constexpr double lagrange = 6; // most points of this interpolation; the other one needs 4 on each axis
    const bool few = x * y <= lagrange;
    if (!few && klipper) {
        x = std::max(x, 4.0);
        y = std::max(y, 4.0);
    }
    to.set("bed_mesh_probe_count", Variable::many({whole_value(x), whole_value(y)}));
    to.set("bed_mesh_algo", Variable::one(std::string(few ? "lagrange" : "bicubic")));
}

// Sets other names of settings that OrcaSlicer offers to macros.
void set_other_names(const Job& job, Settings& to) {
    std::vector<Value> exhaust;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, to.texts("during_print_exhaust_fan_speed").size()); ++i)
        exhaust.push_back(static_cast<std::int64_t>(to.number("during_print_exhaust_fan_speed", i) / 100 * 255));
    to.set("during_print_exhaust_fan_speed_num", Variable::many(exhaust));
    const std::pair<const char*, const char*> same[] = {{"retract_length", "retraction_length"},
                                                        {"filament_ids", "filament_id"},
                                                        {"first_layer_height", "initial_layer_print_height"}};
    for (const auto& [name, from] : same)
        if (const Variable* found = to.find(from)) to.set(name, *found);
    // OrcaSlicer offers the height as a whole number, so that its half is one, too.
    to.set("max_print_height", Variable::one(whole_value(std::trunc(to.number("printable_height")))));
    to.set("long_retraction_when_cut", Variable::one(to.number("long_retractions_when_cut", job.first_tool) != 0));
    to.set("retraction_distance_when_cut", Variable::one(to.number("retraction_distances_when_cut", job.first_tool)));
    to.set("initial_no_support_tool", Variable::one(whole_value(job.first_tool)));
    to.set("bbl_bed_temperature_gcode", Variable::one(false));
    to.set("relative_e_axis", Variable::one(to.flag("use_relative_e_distances")));
    to.set("model_name", Variable::one(std::string()));
}

// Sets how each filament is flushed: where it says nothing, as fast as it melts and as hot as it may become.
void set_flush(const Job& job, Settings& to) {
    const auto set = [&](const char* name, const char* own, const char* otherwise) {
        std::vector<Value> out;
        for (std::size_t i = 0, n = std::max<std::size_t>(1, to.texts(otherwise).size()); i < n; ++i) {
            const double value = to.number(own, i);
            out.emplace_back(value > 0 ? value : to.number(otherwise, i));
        }
        to.set(name, Variable::many(out));
    };
    set("flush_volumetric_speeds", "filament_flush_volumetric_speed", "filament_max_volumetric_speed");
    set("flush_temperatures", "filament_flush_temp", "nozzle_temperature_range_high");
    to.set("long_retraction_when_ec", Variable::one(to.number("long_retractions_when_ec", job.first_tool) != 0));
    to.set("retraction_distance_when_ec", Variable::one(to.number("retraction_distances_when_ec", job.first_tool)));
}

// Sets whether the chamber stays warm for a large print of one layer: its area, volume over height, exceeds that of a
// square 200 mm wide; on a bed wider than 260 mm, of one 70 mm smaller than the bed.
void set_flat_print(const Job& job, Settings& to) {
    constexpr double wide = 260, less = 70, usual = 200, about = 1e-4; // mm
    const Extent bed = extent(corners(to.texts("printable_area")));
    const double x = bed.high.x - bed.low.x, y = bed.high.y - bed.low.y;
    const double side = x > wide && y > wide ? std::max(x, y) - less : usual;
    double volume = 0;
    for (const auto& [tool, mm3] : job.volume) volume += mm3;
    const bool flat = job.height > 0 && job.height < to.number("initial_layer_print_height", 0, 0.2) + about;
    to.set("hold_chamber_temp_for_flat_print", Variable::one(flat && volume / job.height > side * side));
}

// Sets what Bambu Studio names a filament, its extruder (from 0) and its nozzle; hotends have the number -1, except
// those of a printer that chooses them itself.  Sets the fastest auxiliary fan, too, and the most acceleration of the
// bed. Bambu Studio takes the mass that is on the bed so far; Filum takes that of the whole job.
void set_hotends(const Job& job, double extruder, std::size_t nozzles, Settings& to) {
    for (const char* name : {"initial_filament_id", "initial_no_support_filament_id", "current_filament_id"})
        to.set(name, Variable::one(whole_value(job.first_tool)));
    for (const char* name : {"initial_extruder_id", "initial_no_support_extruder_id", "current_extruder_id",
                             "initial_nozzle_id", "initial_no_support_nozzle_id", "current_nozzle_id"})
        to.set(name, Variable::one(whole_value(extruder)));
    for (const char* name : {"initial_no_support_hotend", "current_hotend"})
        to.set(name, Variable::one(whole_value(-1)));
    to.set("first_non_support_hotend", Variable::many(std::vector<Value>(nozzles, whole_value(-1))));
    if (const Variable* found = to.find("nozzle_diameter")) to.set("nozzle_diameter_at_nozzle_id", *found);
    to.set("clear_to_x0", Variable::one(false));
    double fan = 0, grams = 0;
    for (const std::uint32_t tool : job.tools) fan = std::max(fan, to.number("additional_cooling_fan_speed", tool));
    to.set("max_additional_fan", Variable::one(fan));
    for (const auto& [tool, mm3] : job.volume) grams += mm3 / 1000 * to.number("filament_density", tool);
    const double force = to.number("machine_max_force_Y") * 1e6, bed = to.number("machine_bed_mass_Y"); // g mm/s2, g
    const double most = to.number("machine_max_acceleration_y");
    const double limit = force > 0 && bed > 0 && grams > 0 ? std::min(most, force / (bed + grams)) : most;
    to.set("curr_y_acceleration_limit", Variable::one(limit));
}

// Sets the values that newer versions of Bambu Studio compute (GCode.cpp of version 2).
void set_bambu(const Job& job, Settings& to) {
    const auto has = [&](const char* key, const char* value) {
        return [&to, key, value](std::uint32_t tool) {
            const auto texts = to.texts(key);
            return tool < texts.size() && texts[tool] == value;
        };
    };
    to.set("is_all_bbl_filament", Variable::one(std::ranges::all_of(job.tools, has("filament_vendor", "Bambu Lab"))));
    to.set("has_tpu_in_first_layer", Variable::one(std::ranges::any_of(job.tools, has("filament_type", "TPU"))));
    double glass = std::numeric_limits<int>::max();
    for (const std::uint32_t tool : job.tools) glass = std::min(glass, to.number("temperature_vitrification", tool));
    to.set("min_vitrification_temperature", Variable::one(whole_value(glass)));
    to.set("max_print_z", Variable::one(whole_value(std::ceil(job.height))));
    to.set("enable_high_low_temp_mix", Variable::one(false));
    set_flush(job, to);
    // The nozzle of the first filament; the others have none.
    const std::size_t nozzles = std::max<std::size_t>(1, to.texts("nozzle_diameter").size());
    const double extruder = nozzles > 1 ? to.number("filament_map", job.first_tool, 1) - 1 : 0;
    const double nozzle = to.number("physical_extruder_map", static_cast<std::size_t>(std::max(0.0, extruder)), 0);
    std::vector<Value> first;
    for (std::size_t i = 0; i < nozzles; ++i)
        first.emplace_back(whole_value(static_cast<double>(i) == nozzle ? job.first_tool : -1.0));
    for (const char* name :
         {"first_filaments", "first_tools", "first_non_support_filaments", "first_non_support_tools"})
        to.set(name, Variable::many(first));
    set_hotends(job, extruder, nozzles, to);
    for (const char* name : {"most_used_physical_extruder_id", "curr_physical_extruder_id"})
        to.set(name, Variable::one(whole_value(nozzle)));
    to.set("has_timelapse_safe_pos", Variable::one(false));
    to.set("wipe_tower_center_pos_valid", Variable::one(false)); // Filum prints no such tower
    for (const char* name : {"wipe_tower_center_pos_x", "wipe_tower_center_pos_y"}) to.set(name, Variable::one(0.0));
    set_flat_print(job, to);
    for (const char* name : {"timelapse_pos_x", "timelapse_pos_y"}) to.set(name, Variable::one(whole_value(0)));
}

// Sets the values that OrcaSlicer and Bambu Studio compute.
void set_orca(const Job& job, const Extent& box, Settings& to) {
    const std::string plate = to.text("curr_bed_type");
    const std::string key = plate == "Cool Plate"            ? "cool_plate_temp"
                            : plate == "Engineering Plate"   ? "eng_plate_temp"
                            : plate == "High Temp Plate"     ? "hot_plate_temp"
                            : plate == "Supertack Plate"     ? "supertack_plate_temp"
                            : plate == "Textured Cool Plate" ? "textured_cool_plate_temp"
                            : plate == "Textured PEI Plate" || to.find("hot_plate_temp") == nullptr
                                ? "textured_plate_temp"
                                : "hot_plate_temp";
    const std::pair<const char*, std::string> temperatures[] = {
        {"bed_temperature", key}, {"bed_temperature_initial_layer", key + "_initial_layer"}};
    constexpr double usual = 45; // degrees, of a High Temp Plate in OrcaSlicer where no filament is loaded
    for (const auto& [name, from] : temperatures) {
        const Variable* found = to.find(from);
        Variable list = found != nullptr ? *found : Variable::many({whole_value(usual)});
        list.list = true;
        to.set(name, std::move(list));
        to.set(std::string(name) + "_single", Variable::one(whole_value(to.number(name, job.first_tool))));
    }
    if (plate.empty())
        to.set("curr_bed_type",
               Variable::one(std::string(key == "textured_plate_temp" ? "Textured PEI Plate" : "High Temp Plate")));
    set_outer_wall(to);
    set_bed_mesh(box, to.text("gcode_flavor") == "klipper", to);
    set_other_names(job, to);
    set_bambu(job, to);
    to.set("bed_temperature_initial_layer_vector", Variable::one(std::string()));
    to.set("overall_chamber_temperature", Variable::one(whole_value(to.number("chamber_temperature"))));
    to.set("first_layer_center_no_wipe_tower", point((box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2));
    to.set("initial_no_support_extruder", Variable::one(whole_value(job.first_tool)));
    to.set("max_layer_z", Variable::one(job.height));
    to.set("in_head_wrap_detect_zone", Variable::one(whole_value(0)));
    to.set("plate_name", Variable::one(std::string()));
    to.set("plate_number", Variable::one(whole_value(1)));
    for (const char* old : {"first_layer_temperature", "first_layer_bed_temperature", "temperature"}) {
        const bool bed = std::string(old).find("bed") != std::string::npos;
        const char* name = bed                                 ? "bed_temperature_initial_layer"
                           : std::string(old) == "temperature" ? "nozzle_temperature"
                                                               : "nozzle_temperature_initial_layer";
        if (const Variable* found = to.find(name)) to.set(old, *found);
    }
}

} // namespace

void set_job_values(const Job& job, bool orca, Settings& to) {
    set_box("print_bed", extent(corners(to.texts(orca ? "printable_area" : "bed_shape"))), to);
    const Extent box = extent(job.first_layer);
    set_box("first_layer_print", box, to);
    Variable hull{true, {}, {}};
    for (const geom::Vec2& p : job.first_layer) {
        hull.items.emplace_back("[" + macro::text_of(p.x) + ", " + macro::text_of(p.y) + "]");
        hull.written.push_back(macro::text_of(p.x) + "x" + macro::text_of(p.y));
    }
    to.set("first_layer_print_convex_hull", std::move(hull));
    const std::pair<const char*, double> numbers[] = {{"initial_tool", job.first_tool},
                                                      {"initial_extruder", job.first_tool},
                                                      {"current_extruder", job.first_tool},
                                                      {"total_layer_count", job.layers},
                                                      {"current_object_idx", 0},
                                                      {"total_toolchanges", 0},
                                                      {"toolchange_count", 0},
                                                      {"num_objects", job.objects},
                                                      {"num_instances", job.objects}};
    for (const auto& [name, value] : numbers) to.set(name, Variable::one(whole_value(value)));
    for (const char* name : {"has_wipe_tower", "has_single_extruder_multi_material_priming"})
        to.set(name, Variable::one(false));
    to.set("position", Variable::many({0.0, 0.0, 0.0}));
    for (const char* name : {"e_retracted", "e_restart_extra", "e_position"}) to.set(name, Variable::many({0.0}));
    to.set("zhop", Variable::one(0.0));
    to.set("input_filename_base", Variable::one(job.input));
    to.set("input_filename", Variable::one(job.input + ".gcode"));
    to.set("printer_preset", Variable::one(to.text("printer_settings_id")));
    to.set("print_preset", Variable::one(to.text("print_settings_id")));
    std::vector<Value> filaments;
    for (const std::string& name : to.texts("filament_settings_id")) filaments.emplace_back(name);
    if (filaments.empty()) filaments.emplace_back(std::string());
    to.set("filament_preset", Variable::many(filaments));
    to.set("initial_filament_type", Variable::one(to.text("filament_type", job.first_tool)));
    const std::size_t extruders = std::max<std::size_t>(1, to.texts("nozzle_diameter").size());
    set_material(job, extruders, orca, to);
    to.set("version", Variable::one(std::string("2.9.0")));
    set_clock(job, to);
    if (orca) set_orca(job, box, to);
}

} // namespace filum::preset
