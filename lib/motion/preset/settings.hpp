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

// A profile: printer, print and filament together. Values are texts: one for a single value, one per item for a list.
struct Preset {
    std::string slicer; // "prusa", "super", "orca", "bambu", "slic3r", "cura"; "" if unknown
    std::string input;  // name of the part's file, without folder and extension
    std::map<std::string, std::vector<std::string>, std::less<>> settings;
};

// Splits the value of a line "name = value". A list is split into its items, and \n in texts becomes a line end.
std::vector<std::string> values_of_line(std::string_view key, std::string_view value);
// The same for JSON, where texts need no unescaping.
std::vector<std::string> values_of_json(std::string_view key, std::string_view value);

// Parses the corners of a bed, mm: "0x200" is x 0 and y 200. Throws Error(bad_input) for a text that is not a corner.
std::vector<geom::Vec2> corners(const std::vector<std::string>& texts);

// Settings by name, with defaults for those that the profile lacks.
class Settings {
  public:
    explicit Settings(const Preset& preset);

    [[nodiscard]] const macro::Variable* find(std::string_view name) const;
    void set(const std::string& name, macro::Variable value) { variables_[name] = std::move(value); }

    // The value for an extruder: for a list its item, or the first one if it has none. Missing or nil settings give ""
    // or `otherwise`.
    [[nodiscard]] std::string text(std::string_view name, std::size_t extruder = 0) const;
    [[nodiscard]] double number(std::string_view name, std::size_t extruder = 0, double otherwise = 0) const;
    [[nodiscard]] bool flag(std::string_view name, std::size_t extruder = 0) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view name) const;

  private:
    [[nodiscard]] const macro::Value* value(std::string_view name, std::size_t extruder) const;
    void resolve_shares();
    double width(const std::string& name, double nozzle) const;
    std::map<std::string, macro::Variable, std::less<>> variables_;
};

} // namespace filum::preset
