#include "app/filum/cura_words.hpp"

#include "app/filum/slicer_text.hpp"
#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace filum::app::filum {

namespace {

using Words = std::vector<std::string>;

std::string option_word(const std::string& name, double value) { return "--" + name + "=" + shortest_text(value); }
std::string key_word(const std::string& key, double value) { return "--set=" + key + "=" + shortest_text(value); }
double in_um(double mm) { return std::round(mm * 1e3) / 1e3; }

// Makes the words of settings from the values of all.
class CuraNumbers {
  public:
    CuraNumbers(const CuraStack& cura, Words& remarks) : cura_(cura), remarks_(remarks) {}

    [[nodiscard]] bool has(const std::string& key) const { return cura_.has(key); }
    [[nodiscard]] bool on(const std::string& key) const { return number(key) != 0; }
    // The number; 0 where the file lacks the key and Cura has no usual value.  Throws Error(usage).
    [[nodiscard]] double number(const std::string& key) const {
        const CuraValue value = cura_.value(key);
        if (value.known()) return parse_number(text_of(value), key);
        if (cura_.in_file(key) || !row_of(key, Slicer::cura).usual.empty())
            throw Error(Exit::usage, "'" + key + "' is unknown: " + std::get<MissingValue>(value.as).why);
        return 0;
    }
    // Whether `key` is the first of the keys that the file has.
    [[nodiscard]] bool first(const std::string& key, std::initializer_list<const char*> keys) const {
        for (const char* k : keys)
            if (has(k)) return key == k;
        return false;
    }
    [[nodiscard]] std::string word(const std::string& key) const { return unquoted(cura_.text(key)); }

    [[nodiscard]] Words widths(const std::string& key) const;
    [[nodiscard]] Words walls() const;
    [[nodiscard]] Words shell(const std::string& key, const std::string& side) const;
    [[nodiscard]] Words outlines(const std::string& key) const;
    [[nodiscard]] Words temperature(const std::string& key, const std::string& target) const;
    [[nodiscard]] Words accelerations(const std::string& key, const SettingRow& row) const;
    [[nodiscard]] Words travel(const std::string& target, const char* enabled, const std::string& amount,
                               const std::string& key) const;
    [[nodiscard]] Words cooling(const std::string& key) const;
    [[nodiscard]] Words shrinkage(const std::string& key) const;
    [[nodiscard]] Words supports(const std::string& key) const;
    [[nodiscard]] Words interface(const std::string& key) const;
    [[nodiscard]] Words adhesion(const std::string& key) const;

  private:
    [[nodiscard]] double full_layer() const;
    void remark(const std::string& text) const { remarks_.push_back(text); }
    const CuraStack& cura_;
    Words& remarks_;
};

// The widths by role.  The first key of a width that the file has makes the words of all.
Words CuraNumbers::widths(const std::string& key) const {
    if (!first(key, {"wall_line_width_0", "wall_line_width", "line_width", "machine_nozzle_size", "wall_line_width_x",
                     "infill_line_width", "skin_line_width", "support_line_width", "initial_layer_line_width_factor"}))
        return {};
    const auto mm = [&](const char* width) { return in_um(number(width)); };
    const double outer = mm("wall_line_width_0"), inner = mm("wall_line_width_x");
    Words out{option_word("bead-width", outer)};
    if (number("infill_sparse_density") < 100) {
        if (inner != outer) out.push_back(option_word("inner-width", inner));
        if (mm("infill_line_width") != inner) out.push_back(option_word("infill-width", mm("infill_line_width")));
        if (mm("skin_line_width") != inner) out.push_back(option_word("solid-width", mm("skin_line_width")));
    }
    if (on("support_enable") && mm("support_line_width") != outer)
        out.push_back(option_word("support-width", mm("support_line_width")));
    const double factor = number("initial_layer_line_width_factor") / 100;
    if (factor != 1) out.push_back(option_word("first-layer-width", in_um(factor * outer)));
    return out;
}

// The number of walls that fit the thickness, at least one.
Words CuraNumbers::walls() const {
    if (has("wall_line_count")) return {};
    const double inner = number("wall_line_width_x");
    const double further = inner > 0 ? (number("wall_thickness") - number("wall_line_width_0")) / inner : 0;
    return {option_word("walls", std::max(1.0, std::round(further) + 1))};
}

// The number of top or bottom layers for a thickness.  A solid part has none, since Cura's `top_layers` is 0 then and
// Filum ignores it.
Words CuraNumbers::shell(const std::string& key, const std::string& side) const {
    const std::string own = side + "_thickness";
    if (has(side + "_layers") || (key != own && has(own))) return {};
    const double height = number("layer_height");
    if (!(height > 0)) return {};
    return {option_word(side, std::ceil(std::round(number(key) / height * 1e4) / 1e4))};
}

// A positive `xy_offset` moves outlines outwards and makes holes narrower, as --xy-compensation does.
Words CuraNumbers::outlines(const std::string& key) const {
    if (key == "xy_offset_layer_0") {
        const double foot = in_um(number("xy_offset") - number(key));
        if (foot < 0) remark("xy_offset_layer_0 widens the first layer: not followed");
        return foot > 0 ? Words{option_word("elephant-foot", foot)} : Words{};
    }
    if (number(key) == 0) return {};
    return {option_word(key == "xy_offset" ? "xy-compensation" : "hole-compensation", number(key))};
}

Words CuraNumbers::temperature(const std::string& key, const std::string& target) const {
    if (key.starts_with("default_") && has(key.substr(std::string("default_").size()))) return {};
    const bool nozzle = target.ends_with("nozzle_temp");
    return nozzle && !(number(key) > 0) ? Words{} : Words{key_word(target, number(key))};
}

Words CuraNumbers::accelerations(const std::string& key, const SettingRow& row) const {
    if (!on("acceleration_enabled") || !(number(key) > 0) || row.target.empty()) return {};
    return {key_word(std::string(row.target), number(key))};
}

// A length of the travel that another key switches off.
Words CuraNumbers::travel(const std::string& target, const char* enabled, const std::string& amount,
                          const std::string& key) const {
    if (!first(key, {enabled, amount.c_str()})) return {};
    return {key_word(target, on(enabled) ? number(amount) : 0)};
}

// The layer from which on the fan has its full speed, from 0.
double CuraNumbers::full_layer() const {
    if (has("cool_fan_full_layer")) return number("cool_fan_full_layer");
    if (!has("cool_fan_full_at_height") || !(number("layer_height") > 0)) return 1;
    const double above = (number("cool_fan_full_at_height") - number("layer_height_0")) / number("layer_height");
    return std::max(1.0, std::floor(std::round(above * 1e4) / 1e4) + 2);
}

// Cura's fan has the minimum speed on layers that take `cool_min_layer_time_fan_speed_max` seconds or more, and the
// maximum on those that take `cool_min_layer_time`.  On the first layer it has `cool_fan_speed_0`, and the speed rises
// up to the layer full_layer().
Words CuraNumbers::cooling(const std::string& key) const {
    if (!first(key, {"cool_fan_enabled", "cool_fan_speed", "cool_fan_speed_max", "cool_fan_speed_min",
                     "cool_min_layer_time", "cool_min_layer_time_fan_speed_max", "cool_fan_full_layer",
                     "cool_fan_full_at_height", "cool_fan_speed_0"}))
        return {};
    const bool fan = on("cool_fan_enabled");
    const auto speed = [&](const char* share) { return fan ? std::round(25.5 * number(share)) / 10 : 0; };
    const double slow = number("cool_min_layer_time");
    Words out{key_word("limits.layer_time", slow),
              key_word("cooling.most", speed("cool_fan_speed_max")),
              key_word("cooling.least", speed("cool_fan_speed_min")),
              key_word("cooling.idle", speed("cool_fan_speed_min")),
              key_word("cooling.fast", slow),
              key_word("cooling.below", std::max(slow, number("cool_min_layer_time_fan_speed_max")))};
    const bool still = number("cool_fan_speed_0") == 0;
    if (!still && number("cool_fan_speed_0") != number("cool_fan_speed_max"))
        remark("cool_fan_speed_0: the fan of the first layer is that of the others");
    out.push_back(key_word("cooling.off_layers", still ? 1 : 0));
    out.push_back(key_word("cooling.full_layer", still && full_layer() > 1 ? full_layer() + 1 : 0));
    if (on("bridge_settings_enabled")) out.push_back(key_word("cooling.bridge", speed("bridge_fan_speed")));
    return out;
}

// Cura scales the part by these percentages; --shrinkage takes what the material loses of its size, in percent.
Words CuraNumbers::shrinkage(const std::string& key) const {
    if (!first(key, {"material_shrinkage_percentage", "material_shrinkage_percentage_xy",
                     "material_shrinkage_percentage_z"}))
        return {};
    const auto lost = [&](const char* axis) {
        const double factor = has(axis) ? number(axis) : number("material_shrinkage_percentage");
        return factor > 100 ? std::round((100 - 1e4 / factor) * 1e6) / 1e6 : 0;
    };
    const double xy = lost("material_shrinkage_percentage_xy"), z = lost("material_shrinkage_percentage_z");
    if (!(xy > 0) && !(z > 0)) return {};
    const std::string flat = shortest_text(xy);
    return {"--shrinkage=" + flat + "," + flat + "," + shortest_text(z)};
}

Words CuraNumbers::supports(const std::string& key) const {
    if (!on("support_enable")) return {};
    if (key == "support_enable") return {"--support"};
    if (key == "support_structure" && word(key) == "tree") remark("supports are upright ones: Filum has no trees");
    if (key == "support_type" && word(key) == "buildplate") return {"--support-on=bed"};
    if (key == "support_infill_rate" && !has("support_line_distance") && number(key) > 0)
        return {option_word("support-spacing", in_um(100 * number("support_line_width") / number(key)))};
    return {};
}

// The layers of a support next to the part.
Words CuraNumbers::interface(const std::string& key) const {
    if (!first(key,
               {"support_roof_enable", "support_interface_enable", "support_roof_height", "support_interface_height"}))
        return {};
    const auto either = [&](const char* roof, const char* all) { return number(has(roof) ? roof : all); };
    if (!on("support_enable") || !(number("layer_height") > 0)) return {};
    if (either("support_roof_enable", "support_interface_enable") == 0) return {"--interface=0"};
    const double layers = either("support_roof_height", "support_interface_height") / number("layer_height");
    return {option_word("interface", std::min(100.0, std::ceil(std::round(layers * 1e4) / 1e4)))};
}

Words CuraNumbers::adhesion(const std::string& key) const {
    if (!first(key, {"adhesion_type", "brim_width", "brim_line_count", "skirt_gap", "skirt_line_count",
                     "raft_surface_layers"}))
        return {};
    const std::string type = word("adhesion_type");
    if (type == "skirt" && number("skirt_line_count") > 0 && number("skirt_gap") > 0)
        return {option_word("skirt", number("skirt_gap"))};
    if (type == "brim") {
        const bool lines = has("brim_line_count") && !has("brim_width");
        const double mm = lines ? number("brim_line_count") * number("skirt_brim_line_width") : number("brim_width");
        return mm > 0 ? Words{option_word("brim", in_um(mm))} : Words{};
    }
    // A raft of Cura has a base, a layer between, and the surface.
    return type == "raft" ? Words{option_word("raft", 2 + number("raft_surface_layers"))} : Words{};
}

} // namespace

Words cura_words(const CuraStack& stack, const std::string& key, const SettingRow& row, Words& remarks) {
    const CuraNumbers cura(stack, remarks);
    const std::string target(row.target);
    if (target == "width") return cura.widths(key);
    if (target == "walls") return cura.walls();
    if (target == "top" || target == "bottom") return cura.shell(key, target);
    if (target == "shells") {
        Words out = cura.shell(key, "top");
        std::ranges::copy(cura.shell(key, "bottom"), std::back_inserter(out));
        return out;
    }
    if (target == "xy-compensation" || target == "elephant-foot") return cura.outlines(key);
    if (target.ends_with("_temp")) return cura.temperature(key, target);
    if (target == "extrusion.flow") return {key_word(target, cura.number(key) / 100)};
    if (target.ends_with("acceleration")) return cura.accelerations(key, row);
    if (target == "travel.retract") return cura.travel(target, "retraction_enable", "retraction_amount", key);
    if (target == "travel.lift") return cura.travel(target, "retraction_hop_enabled", "retraction_hop", key);
    if (target == "cooling") return cura.cooling(key);
    if (target == "shrinkage") return cura.shrinkage(key);
    if (target.starts_with("support")) return cura.supports(key);
    if (target == "interface") return cura.interface(key);
    if (target == "adhesion") return cura.adhesion(key);
    if (target == "vase") return cura.on(key) ? Words{"--vase"} : Words{};
    return {};
}

} // namespace filum::app::filum
