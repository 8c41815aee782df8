// Reads the values in one file of a slicer's settings as numbers.
#pragma once

#include "app/filum/slicer_table.hpp"

#include <map>
#include <string>

namespace filum::app::filum {

class SlicerValues {
  public:
    explicit SlicerValues(const SlicerFile& file);

    [[nodiscard]] Slicer slicer() const { return slicer_; }
    [[nodiscard]] bool of_orca() const { return slicer_ == Slicer::orca || slicer_ == Slicer::bambu; }
    // True if a width in percent refers to the layer height, false if it refers to the nozzle.
    [[nodiscard]] bool width_is_of_layer() const { return !of_orca() && slicer_ != Slicer::super; }

    // The value without quotes; of a list the item of the extruder that prints perimeters, or the first item if the
    // list is shorter.  "" for a key that is missing or nil.
    [[nodiscard]] std::string text(const std::string& key) const;
    // The value as in the file, with all items of a list; "" for a key that is missing.
    [[nodiscard]] std::string whole(const std::string& key) const;
    [[nodiscard]] bool percent(const std::string& key) const { return text(key).ends_with('%'); }
    // The number, without a '%' behind it.  Throws Error(usage) if the value is no number.
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] double number_or(const std::string& key, double otherwise) const;

    // The percentage `key`, applied to the value of the key row.of; without one, to the default value of that key.
    [[nodiscard]] double share_of(const std::string& key, const SettingRow& row) const;
    // The speed in mm/s; 0: the slicer chooses the speed.  `depth`: how many percentages refer to each other so far.
    // Throws Error(usage) for a percentage that refers to nothing.
    [[nodiscard]] double speed(const std::string& key, const SettingRow& row, int depth = 0) const;
    // The density in percent.  Slic3r wrote fractions (0.4 for 40 %), and PrusaSlicer still reads them so.  Thus a
    // value up to 1 without '%' is a fraction, except in files of OrcaSlicer, Bambu Studio and Cura.
    [[nodiscard]] double density(const std::string& key) const;
    // Throws Error(usage) if the value cannot be meant: a list where the slicer has one number, a percentage of
    // nothing, or a number out of the range of the setting.
    void check(const std::string& key, const SettingRow& row) const;
    // Whether the key "filament_" + `key` is set, which replaces the value of `key`.
    [[nodiscard]] bool overridden(const std::string& key, const SettingRow& row) const;

  private:
    Slicer slicer_;
    std::map<std::string, std::string> values_;
    std::size_t extruder_ = 0; // the one that prints perimeters, from 0
};

// Throws Error(bad_input) if numbers of the file have decimal commas, which make lists of them; `name` is the file's.
void refuse_decimal_commas(const SlicerFile& file, const std::string& name);

} // namespace filum::app::filum
