// The settings of a slicer's profile as variables of its macros.
#pragma once

#include "geom/vec.hpp"
#include "macro/macro.hpp"
#include "preset/table.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace filum::preset {

// A profile: printer, print and filament in one.  Values as texts: one for a setting of one value, one each for lists.
struct Preset {
    std::string slicer; // "prusa", "super", "orca", "bambu", "slic3r"; "" if unknown
    std::string input;  // name of the part's file, without folder and ending
    std::map<std::string, std::vector<std::string>, std::less<>> settings;
};

// The values of a setting as a line "name = value" has them: parted where the type is a list, \n in texts as line ends.
std::vector<std::string> values_of_line(std::string_view key, std::string_view value);
// The same of JSON: texts stand as they are.
std::vector<std::string> values_of_json(std::string_view key, std::string_view value);

// The corners of a bed, "0x200" for x 0 and y 200.  Throws Error(bad_input) for a text that is none.
std::vector<geom::Vec2> corners(const std::vector<std::string>& texts);

// Settings by name, with the defaults of those that the profile lacks.
class Settings {
  public:
    explicit Settings(const Preset& preset);

    [[nodiscard]] const macro::Variable* find(std::string_view name) const;
    void set(const std::string& name, macro::Variable value) { variables_[name] = std::move(value); }

    // The value for an extruder: of a list its item, or the first one.  "" or `otherwise` for a setting that is
    // missing or nil.
    [[nodiscard]] std::string text(std::string_view name, std::size_t extruder = 0) const;
    [[nodiscard]] double number(std::string_view name, std::size_t extruder = 0, double otherwise = 0) const;
    [[nodiscard]] bool flag(std::string_view name, std::size_t extruder = 0) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;

  private:
    [[nodiscard]] const macro::Value* value(std::string_view name, std::size_t extruder) const;
    void resolve_shares();
    double width(const std::string& name, double nozzle) const;
    std::map<std::string, macro::Variable, std::less<>> variables_;
    std::map<std::string, bool, std::less<>> shares_; // that are a percentage
};

} // namespace filum::preset
