#include "machine/template.hpp"

#include "macro/macro.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace filum::machine {

namespace {

// A number of a template as a variable of the macro language.
class NumberVariables {
  public:
    explicit NumberVariables(const Values& values) : values_(values) {}

    const macro::Variable* find(std::string_view name) {
        const auto known = made_.find(name);
        if (known != made_.end()) return &known->second;
        const auto value = values_.find(std::string(name));
        if (value == values_.end()) return nullptr;
        return &made_.emplace(std::string(name), macro::Variable::one(value->second)).first->second;
    }

  private:
    const Values& values_;
    std::map<std::string, macro::Variable, std::less<>> made_;
};

} // namespace

const std::vector<std::string>& known_placeholders() {
    static const std::vector<std::string> names = {"x_min",
                                                   "x_max",
                                                   "y_min",
                                                   "y_max",
                                                   "z_min",
                                                   "z_max",
                                                   "x_start",
                                                   "y_start",
                                                   "z_start",
                                                   "bed_x_min",
                                                   "bed_x_max",
                                                   "bed_y_min",
                                                   "bed_y_max",
                                                   "bed_z_max",
                                                   "z_park",
                                                   "percent",
                                                   "minutes_left",
                                                   "acceleration",
                                                   "fan_speed",
                                                   "layer",
                                                   "layers",
                                                   "z",
                                                   "height",
                                                   "path_len",
                                                   "travel_len",
                                                   "time",
                                                   "strokes",
                                                   "material_mm3",
                                                   "material_e",
                                                   "travel_feed",
                                                   "z_feed",
                                                   "tool_no",
                                                   "tool_last",
                                                   "purge_s",
                                                   "purge_ms",
                                                   "cut_dwell",
                                                   "cut_dwell_ms",
                                                   "tension_dwell",
                                                   "tension_dwell_ms",
                                                   "purge_x",
                                                   "purge_y",
                                                   "purge_x_end",
                                                   "purge_y_end",
                                                   "tilt_axis_speed",
                                                   "turn_axis_speed",
                                                   "tilt_axis_acceleration",
                                                   "turn_axis_acceleration",
                                                   "tilt_axis_jump",
                                                   "turn_axis_jump"};
    return names;
}

TemplateFault check_template(std::string_view text, const Values& own) {
    const auto& known = known_placeholders();
    std::string unknown;
    const auto fault = macro::fault(text, macro::Style::own, [&](std::string_view name) {
        if (own.contains(std::string(name)) || std::find(known.begin(), known.end(), name) != known.end()) return true;
        unknown = name;
        return false;
    });
    if (!fault) return {};
    if (unknown.empty()) return {fault->why + "; write {{ or }} for a plain brace", fault->line - 1};
    return {"unknown placeholder '{" + unknown + "}'; add '" + unknown + "' to [values] or see postproc --help",
            fault->line - 1};
}

std::set<std::string> words_in_braces(std::string_view text) {
    std::set<std::string> out;
    std::string word;
    bool within = false;
    for (const char c : text) {
        const bool letter = c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (within && letter) word += c;
        if (!letter && !word.empty()) out.insert(std::exchange(word, {}));
        if (c == '{') within = true;
        if (c == '}') within = false;
    }
    return out;
}

std::string expand(std::string_view text, const Values& values, int decimals) {
    if (text.find_first_of("{}") == std::string_view::npos) return std::string(text);
    NumberVariables numbers(values);
    macro::Scope scope;
    scope.find = [&](std::string_view name) { return numbers.find(name); };
    scope.numbers.decimals = decimals;
    return macro::expand(macro::parsed("a template", std::string(text), macro::Style::own), scope);
}

} // namespace filum::machine
