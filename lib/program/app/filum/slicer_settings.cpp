#include "app/filum/slicer_settings.hpp"

#include "app/filum/cura_file.hpp"
#include "app/filum/cura_words.hpp"
#include "app/filum/slicer_overhangs.hpp"
#include "app/filum/slicer_values.hpp"
#include "app/filum/slicer_widths.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "cli/other_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>

namespace filum::app::filum {

namespace {

using cli::Value;
using Words = std::vector<std::string>;

std::string option(std::string_view name, const std::string& value) { return "--" + std::string(name) + "=" + value; }
std::string option(std::string_view name, double value) { return option(name, shortest_text(value)); }
std::string set(std::string_view key, double value) { return "--set=" + std::string(key) + "=" + shortest_text(value); }

constexpr double kNoFlowLimit = 1e5; // mm3/s: more than any hot end melts

// Makes the words of one setting; none if Filum does anyway what the setting asks for.  Throws Error for a value that
// has no meaning in Filum.
class Reader {
  public:
    Reader(const SlicerFile& file, const SlicerValues& values, Words& remarks)
        : cura_(file.slicer == Slicer::cura ? file : SlicerFile{}), values_(values), remarks_(remarks) {}

    Words words(const std::string& key, const SettingRow& row) {
        const std::string value = values_.text(key);
        if (value.empty() || values_.overridden(key, row)) return {};
        values_.check(key, row);
        if (row.reading == "special") return special(key, row);
        if (row.reading == "number") return {option(row.target, values_.number(key))};
        if (row.reading == "nonzero" || row.reading == "positive" || row.reading == "foot")
            return {positive(key, row, row.reading == "nonzero")};
        if (row.reading == "count") return count(key, row);
        if (row.reading == "shell") return shell(key, row);
        if (row.reading == "share") return {option(row.target, shortest_text(values_.density(key)) + "%")};
        if (row.reading == "speed") return speed(key, row);
        if (row.reading == "first_speed") return first_speed(key, row);
        if (row.reading == "key" || row.reading == "key_positive") {
            const double number = values_.number(key);
            return number > 0 || row.reading == "key" ? Words{set(row.target, number)} : Words{};
        }
        if (row.reading == "celsius") return celsius(key, row);
        if (row.reading == "acceleration") return accelerations(key, row);
        if (row.reading == "first_acceleration") // 0 means that of the beads' kinds
            return values_.number(key) > 0 ? Words{set(row.target, acceleration(key, row))} : Words{};
        if (row.reading == "flow") return {set(row.target, most_flow())};
        if (row.reading == "supported")
            return supports() && !values_.percent(key) && values_.number(key) > 0
                       ? Words{option(row.target, values_.number(key))}
                       : Words{};
        if (row.reading == "base" || row.reading == "machine") return {}; // machine_of reads these settings
        return by_name(key, row, value);
    }

    [[nodiscard]] bool supports() const {
        return values_.text("support_material") == "1" || values_.text("enable_support") == "1" ||
               values_.text("support_enable") == "1"; // of Cura
    }
    [[nodiscard]] bool supports_by_hand() const {
        return values_.text("support_material_auto") == "0" ||
               values_.text("support_type").find("(manual)") != std::string::npos;
    }

  private:
    Words positive(const std::string& key, const SettingRow& row, bool negative_too) {
        double number = values_.percent(key) ? values_.share_of(key, row) : values_.number(key);
        // To make the first layer smaller, the value is positive in PrusaSlicer and negative in SuperSlicer.
        if (row.reading == "foot" && key == "first_layer_size_compensation") number = -number;
        if (number > 0 || (negative_too && number != 0)) return {option(row.target, number)};
        return {};
    }

    Words count(const std::string& key, const SettingRow& row) {
        if (values_.number(key) >= 1) return {option(row.target, values_.number(key))};
        remarks_.push_back(key + " = 0: Filum lays at least one wall");
        return {option(row.target, 1)};
    }

    // The number of layers, or more if the least thickness (row.of, mm) needs more.  0 layers stay 0.
    Words shell(const std::string& key, const SettingRow& row) {
        const double layers = values_.number(key), height = values_.number_or("layer_height", 0);
        const double thickness = values_.number_or(std::string(row.of), 0);
        if (!(layers > 0 && height > 0 && thickness > 0)) return {option(row.target, layers)};
        const double needed = std::ceil(std::round(thickness / height * 1e6) / 1e6); // without rounding errors
        return {option(row.target, std::max(layers, needed))};
    }

    Words speed(const std::string& key, const SettingRow& row) {
        const double mm_s = values_.speed(key, row);
        if (!(mm_s > 0)) return {};
        Words out{set(row.target, mm_s)};
        // Beads without a kind are those of regions that are solid throughout.
        if (row.target == "feeds.solid") out.push_back(set("feeds.bead", mm_s));
        return out;
    }

    // A percentage is one of the speed of each bead.  SuperSlicer's speed is the most that beads may have, that of the
    // other slicers replaces the beads' own.
    Words first_speed(const std::string& key, const SettingRow& row) {
        if (values_.percent(key)) return {set("feeds.first_layer_share", values_.number(key) / 100)};
        Words out = speed(key, row);
        if (!out.empty() && values_.slicer() != Slicer::super) out.emplace_back("--set=feeds.first_layer_exact=true");
        return out;
    }

    // The lower one of the limits of the print and of the filament, mm3/s; 0 of a setting means no limit.
    [[nodiscard]] double most_flow() const {
        double out = kNoFlowLimit;
        for (const char* key : {"max_volumetric_speed", "filament_max_volumetric_speed"})
            if (const double own = values_.number_or(key, 0); own > 0) out = std::min(out, own);
        return out;
    }

    Words celsius(const std::string& key, const SettingRow& row) {
        if (values_.number(key) > 0) return {set(row.target, values_.number(key))};
        remarks_.push_back(key +
                           " = 0: the slicer leaves it to the start codes; Filum heats as its machine profile says");
        return {};
    }

    // Converts values that are words or flags.  Throws Error(usage) for a value that Filum does not have.
    Words by_name(const std::string& key, const SettingRow& row, const std::string& value) {
        constexpr std::pair<std::string_view, Value> kReadings[] = {{"pattern", Value::pattern},
                                                                    {"seam", Value::seam},
                                                                    {"steepness", Value::steepness},
                                                                    {"bed_only", Value::bed_only}};
        if ((row.reading == "steepness" || row.reading == "bed_only") && (!supports() || value == "0")) return {};
        for (const auto& [name, reading] : kReadings) {
            if (row.reading != name) continue;
            if (const auto word = cli::our_word({key, row.target, reading}, value)) return {*word};
        }
        throw Error(Exit::usage, "Filum has no '" + value + "'");
    }

    // Settings that depend on several keys.  The first of these keys that is set makes the words, the others make none.
    Words special(const std::string& key, const SettingRow& row) {
        if (values_.slicer() == Slicer::cura) return cura_words(cura_, key, row, remarks_);
        if (row.target.ends_with("width")) return width(key);
        if (row.target == "brim") return key == "brim_width" ? brim() : Words{};
        if (row.target == "cooling")
            return first_of(key, {"max_fan_speed", "fan_max_speed", "min_fan_speed", "fan_min_speed"}) ? cooling()
                                                                                                       : Words{};
        if (row.target == "overhang") return overhang_words(values_, key, remarks_);
        if (row.target == "wipe") return key.ends_with("wipe") && !key.ends_with("before_wipe") ? wipe() : Words{};
        if (row.target == "thumbnails") return thumbnails(values_.whole(key));
        if (row.target == "vase") return values_.number(key) != 0 ? Words{"--vase"} : Words{};
        if (row.target == "skirt") return key == "skirt_distance" ? skirt() : Words{};
        if (row.target == "shrinkage")
            return first_of(key, {"filament_shrink", "filament_shrinkage_compensation_xy",
                                  "filament_shrinkage_compensation_z"})
                       ? shrinkage()
                       : Words{};
        if (row.target == "xy-compensation")
            return first_of(key, {"xy_size_compensation", "xy_contour_compensation", "xy_inner_size_compensation",
                                  "hole_size_compensation", "xy_hole_compensation"})
                       ? compensation()
                       : Words{};
        if (row.target == "support")
            return (key == "support_material" || key == "enable_support") && supports() && !supports_by_hand()
                       ? Words{"--support"}
                       : Words{};
        return bed(key, row);
    }

    bool first_of(const std::string& key, std::initializer_list<const char*> keys) const {
        for (const char* k : keys)
            if (!values_.text(k).empty()) return key == k;
        return false;
    }

    // Widths by role.  Only a part with sparse areas has several: a solid one is filled with beads of one width.
    Words width(const std::string& key) {
        const char* density = values_.of_orca() ? "sparse_infill_density" : "fill_density";
        const bool sparse = !values_.text(density).empty() && values_.density(density) < 100;
        return width_words(values_, key, {sparse, supports()}, remarks_);
    }

    Words brim() {
        const std::string type = values_.text("brim_type");
        const double mm = values_.number("brim_width");
        if (mm <= 0 || type == "no_brim") return {};
        if (type == "outer_only" || (type.empty() && !values_.of_orca())) return {option("brim", mm)};
        if (type == "outer_and_inner") {
            remarks_.push_back("brim_type = outer_and_inner: the outer brim only");
            return {option("brim", mm)};
        }
        remarks_.push_back("no brim: brim_type is " + (type.empty() ? "auto_brim, the slicer's default," : type) +
                           " and Filum makes outer ones; add --brim");
        return {};
    }

    // The sizes of "16x16/PNG, 220x124": Filum draws PNG pictures, and a remark names other forms.
    Words thumbnails(const std::string& text) {
        const std::string usual = values_.text("thumbnails_format");
        std::string sizes, other;
        std::istringstream items(text);
        for (std::string item; std::getline(items, item, ',');) {
            std::erase_if(item, [](char c) { return c == ' ' || c == '"'; });
            const std::size_t slash = std::min(item.find('/'), item.size());
            const std::string form = slash < item.size() ? item.substr(slash + 1) : usual.empty() ? "PNG" : usual;
            int width = 0, height = 0, end = 0;
            if (std::sscanf(item.c_str(), "%4dx%4d%n", &width, &height, &end) == 2 && width == 0 && height == 0)
                continue;
            const bool drawn = form == "PNG" && static_cast<std::size_t>(end) == slash &&
                               std::min(width, height) >= 8 &&
                               std::max(width, height) <= 2000; // sides that --thumbnails takes, pixels
            std::string& list = drawn ? sizes : other;
            list += (list.empty() ? "" : ",") + (drawn ? item.substr(0, slash) : item);
        }
        if (!other.empty())
            remarks_.push_back("thumbnails " + other + " left out: Filum draws PNG of 8 to 2000 pixels a side");
        return sizes.empty() ? Words{} : Words{option("thumbnails", sizes)};
    }

    // The length of a wipe.  PrusaSlicer wipes at four fifths of the travel speed while 95 % of what is left of the
    // retraction is taken back; OrcaSlicer and Bambu Studio have a key for the length.
    Words wipe() const {
        const auto of = [&](const char* name, double otherwise) {
            const std::string own = "filament_" + std::string(name);
            return values_.number_or(values_.text(own).empty() ? name : own, otherwise);
        };
        if (of("wipe", 0) == 0) return {};
        const double before = std::clamp(of("retract_before_wipe", 0) / 100, 0.0, 1.0);
        double mm = of("wipe_distance", 1);
        if (!values_.of_orca()) {
            const double speed = of("retract_speed", 40);
            const double seconds = speed > 0 ? 0.95 * (1 - before) * of("retract_length", 2) / speed : 0;
            mm = std::round(seconds * 0.8 * values_.number_or("travel_speed", 130) * 1e3) / 1e3;
        }
        return mm > 0 ? Words{set("travel.wipe", mm), set("travel.before_wipe", before)} : Words{};
    }

    // The fan speed, which depends on the time of a layer, and the least time of a layer.  The rules are those of
    // PrusaSlicer, OrcaSlicer and Bambu Studio; the latter two have other names and defaults.
    Words cooling() {
        const bool orca = values_.of_orca();
        const auto of = [&](const char* prusa, const char* orcas, double otherwise) {
            return values_.number_or(orca ? orcas : prusa, otherwise);
        };
        const auto speed = [](double percent) { return std::round(25.5 * percent) / 10; }; // 255 is full speed
        const double least = of("min_fan_speed", "fan_min_speed", orca ? 20 : 35);
        const double most = of("max_fan_speed", "fan_max_speed", 100);
        const bool always = of("fan_always_on", "reduce_fan_stop_start_freq", 0) != 0;
        const bool by_time = orca || values_.number_or("cooling", 1) != 0;
        const bool bridges = !orca || values_.number_or("enable_overhang_bridge_fan", 1) != 0;
        const double slow = by_time ? of("slowdown_below_layer_time", "slow_down_layer_time", 5) : 0;
        Words out{
            set("limits.layer_time", slow),
            set("cooling.most", speed(most)),
            set("cooling.least", speed(least)),
            set("cooling.idle", always ? speed(least) : 0),
            set("cooling.fast", slow),
            set("cooling.below", by_time ? of("fan_below_layer_time", "fan_cooling_layer_time", 60) : 0),
            set("cooling.off_layers", of("disable_fan_first_layers", "close_fan_the_first_x_layers", orca ? 1 : 3)),
            set("cooling.full_layer", of("full_fan_speed_layer", "full_fan_speed_layer", 0))};
        if (bridges) out.push_back(set("cooling.bridge", speed(of("bridge_fan_speed", "overhang_fan_speed", 100))));
        return out;
    }

    // PrusaSlicer up to 2.5 has one acceleration for all perimeters, and one for infill of all kinds.
    Words accelerations(const std::string& key, const SettingRow& row) const {
        const double mm_s2 = acceleration(key, row);
        if (!(mm_s2 > 0)) return {};
        Words out{set(row.target, mm_s2)};
        constexpr std::pair<std::string_view, const char*> kFinerKeys[] = {
            {"perimeter_acceleration", "external_perimeter_acceleration"},
            {"infill_acceleration", "solid_infill_acceleration"},
            {"infill_acceleration", "top_solid_infill_acceleration"}};
        for (const auto& [coarse, fine] : kFinerKeys)
            if (key == coarse && values_.text(fine).empty())
                out.push_back(set(row_of(fine, values_.slicer()).target, mm_s2));
        return out;
    }

    // The acceleration in mm/s2; 0: unknown.  The value 0 stands for the acceleration of the key row.of, and a
    // percentage refers to it.
    double acceleration(const std::string& key, const SettingRow& row, int depth = 0) const {
        const std::string base = values_.of_orca() || key != "default_acceleration" ? std::string(row.of) : "";
        const double own = values_.number_or(key, 0);
        if (own > 0 && !values_.percent(key)) return own;
        if (base.empty() || depth > 1) return 0;
        const double whole = acceleration(base, row_of(base, values_.slicer()), depth + 1);
        return own > 0 ? own / 100 * whole : whole;
    }

    Words skirt() {
        const std::string loops = values_.text("skirts").empty() ? values_.text("skirt_loops") : values_.text("skirts");
        const double mm = values_.number("skirt_distance");
        if (loops.empty() || loops == "0") return {};
        if (mm > 0) return {option("skirt", mm)};
        remarks_.push_back("skirt_distance = 0: no skirt, since Filum lays none that touches the part; add --brim");
        return {};
    }

    // PrusaSlicer's value is the lost percentage, at most 10.  OrcaSlicer's and SuperSlicer's value is the percentage
    // that remains, partly under the same key.  So a value above 10 is one that remains.
    Words shrinkage() {
        const auto lost = [&](const char* key, bool left) {
            const double value = values_.text(key).empty() ? (left ? 100 : 0) : values_.number(key);
            return left || value > 10 ? 100 - value : value;
        };
        const double xy = values_.text("filament_shrink").empty() ? lost("filament_shrinkage_compensation_xy", false)
                                                                  : lost("filament_shrink", true);
        const double z = lost("filament_shrinkage_compensation_z", false);
        if (!(xy > 0) && !(z > 0)) return {};
        const std::string flat = shortest_text(std::max(xy, 0.0));
        return {"--shrinkage=" + flat + "," + flat + "," + shortest_text(std::max(z, 0.0))};
    }

    // Filum's --xy-compensation moves all outlines, including holes, and --hole-compensation widens holes in addition.
    // PrusaSlicer has the first.  In OrcaSlicer and SuperSlicer one key moves outer outlines, and others move holes.
    Words compensation() {
        const auto mm = [&](const char* key) { return values_.number_or(key, 0); };
        double outline = mm("xy_size_compensation"), holes = 0;
        if (values_.of_orca()) {
            outline = mm("xy_contour_compensation");
            holes = outline + mm("xy_hole_compensation");
        } else if (values_.slicer() == Slicer::super) {
            holes = outline - mm("xy_inner_size_compensation") + mm("hole_size_compensation");
        }
        const auto in_nm = [](double value) { return std::round(value * 1e6) / 1e6; };
        Words out;
        if (in_nm(outline) != 0) out.push_back(option("xy-compensation", in_nm(outline)));
        if (in_nm(holes) != 0) out.push_back(option("hole-compensation", in_nm(holes)));
        return out;
    }

    // OrcaSlicer and Bambu Studio keep a temperature for each kind of plate.
    Words bed(const std::string& key, const SettingRow&) {
        constexpr std::pair<std::string_view, std::string_view> kPlates[] = {
            {"Cool Plate", "cool_plate_temp"},           {"Engineering Plate", "eng_plate_temp"},
            {"High Temp Plate", "hot_plate_temp"},       {"Textured PEI Plate", "textured_plate_temp"},
            {"Supertack Plate", "supertack_plate_temp"}, {"Textured Cool Plate", "textured_cool_plate_temp"}};
        const std::string type = values_.text("curr_bed_type");
        for (const auto& [name, plate] : kPlates) {
            const bool meant = type.empty() ? plate == "hot_plate_temp" : name == type;
            if (!meant || !key.starts_with(plate)) continue;
            if (key != plate && key != std::string(plate) + "_initial_layer") continue;
            if (type.empty() && key == plate)
                remarks_.push_back("the file does not name its plate: the bed is heated as for the High Temp Plate");
            return {set(key == plate ? "bed_temp" : "first_bed_temp", values_.number(key))};
        }
        return {};
    }

    CuraStack cura_; // of other slicers' files it is empty
    const SlicerValues& values_;
    Words& remarks_;
};

} // namespace

SlicerWishes wishes(const SlicerFile& file, const std::function<bool(std::string_view)>& has) {
    SlicerWishes out;
    out.remarks = file.remarks;
    const SlicerValues values(file);
    Reader reader(file, values, out.remarks);
    out.supports = reader.supports();
    out.supports_by_hand = reader.supports_by_hand();
    for (const SlicerSetting& s : file.settings) {
        const SettingRow row = row_of(s.key, file.slicer);
        ReadSetting& read = out.settings.emplace_back(ReadSetting{s.key, s.value, row.use, std::string(row.why)});
        if (row.use != Use::used) continue;
        if (file.slicer == Slicer::cura && is_formula(s.value)) {
            read.use = Use::later;
            const CuraValue value = CuraStack(file).value(s.key);
            const std::string why = value.known() ? "it was not calculated" : std::get<MissingValue>(value.as).why;
            read.why = "its value is a formula of Cura: " + why + "; write the value instead";
            continue;
        }
        try {
            read.words = reader.words(s.key, row);
        } catch (const Error& e) {
            read.use = Use::later;
            read.why = "its value cannot be used: " + std::string(e.what());
            continue;
        }
        std::erase_if(read.words, [&](const std::string& word) {
            const bool again = word == "--overhang-shares" && std::ranges::find(out.words, word) != out.words.end();
            return again || (!word.starts_with("--set=") && !has(word.substr(2, word.find('=') - 2)));
        });
        out.words.insert(out.words.end(), read.words.begin(), read.words.end());
    }
    return out;
}

} // namespace filum::app::filum
