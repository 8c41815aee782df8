// Writes the parts of a program that a slicer's profile defines: before the first bead, between layers, after the last
// bead.
#pragma once

#include "geom/vec.hpp"
#include "preset/flavor.hpp"
#include "preset/settings.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace filum::preset {

// The properties of a print that macros can use.
struct Job {
    std::vector<std::uint32_t> tools{0}; // tools that extrude, in ascending order
    std::uint32_t first_tool = 0;
    std::uint32_t layers = 1;
    std::vector<geom::Vec2> first_layer{};      // mm, on the bed: corners of the convex hull of its beads
    double height = 0;                          // mm: z of the last layer
    double seconds = 0;                         // duration of the print
    std::map<std::uint32_t, double> volume{};   // mm3, by tool
    std::map<std::uint32_t, double> filament{}; // mm, by tool
    std::uint32_t objects = 1;
    std::string input = "part";          // name of the part's file, without folder and extension
    std::optional<std::int64_t> clock{}; // seconds since 1970; none: SOURCE_DATE_EPOCH, or now
};

class Program {
  public:
    // Throws Error(bad_input) for a flavour that Filum does not write, and for a bed with malformed corners.
    Program(const Preset& preset, Job job);
    // Sets a setting, in all items of a list, to `value` rounded to a whole number: "temperature" to 230.
    void set(const std::string& name, double value);

    // Each of these throws Error(bad_input) with the template, the line and the column of a fault.
    std::string start();
    std::string before_layer(std::uint32_t layer, double z); // `layer` counts from 0; z of the part, mm
    std::string after_layer(std::uint32_t layer, double z);
    std::string change_tool(std::uint32_t to, std::uint32_t layer, double z);
    std::string pause(std::uint32_t layer, double z);
    std::string change_colour(std::uint32_t layer, double z); // the user changes the filament
    std::string end(std::uint32_t layer, double z);

    [[nodiscard]] Flavor flavor() const { return flavor_; }
    [[nodiscard]] std::uint32_t tool() const { return tool_; } // the current tool
    [[nodiscard]] bool of_orca() const { return orca_; }       // the profile is of OrcaSlicer or Bambu Studio
    [[nodiscard]] const Settings& settings() const { return settings_; }

  private:
    std::string around_start(const std::string& own);
    std::string around_orca_start(const std::string& own);
    std::string temperatures(const std::string& start, bool wait);
    std::string first_bed_temperature(const std::string& start);
    std::string later_temperatures();
    std::string printer_code(const std::string& name, std::uint32_t tool);
    std::string filament_code(const char* key, std::uint32_t tool);
    std::string code(const char* key, const std::string& text, std::uint32_t tool);
    [[nodiscard]] std::string code_of(std::initializer_list<const char*> names, std::uint32_t tool = 0) const;
    int tool_word(std::uint32_t tool) const;
    void place(std::uint32_t layer, double z);
    [[nodiscard]] double last_lift(double z) const;

    Settings settings_;
    bool orca_ = false; // OrcaSlicer or Bambu Studio, which have names of their own
    bool heats_ = true; // temperatures are added to a start that sets none; the start of a printer of Cura sets its own
    Flavor flavor_ = Flavor::marlin;
    macro::Scope scope_;
    std::map<std::string, macro::Variable, std::less<>> now_; // values for the current template
    std::map<std::string, macro::Template> read_;             // parsed templates, by their text
    Job job_;
    std::uint32_t tool_ = 0;
    double highest_ = 0; // mm, z of the highest layer so far
    bool warm_ = false;  // the temperatures for layers above the first are set
    int bed_ = -1;       // the bed's temperature as last set
};

} // namespace filum::preset
