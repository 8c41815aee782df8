// The values of one file of settings, as numbers.
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
    // Whether a width in per cent is one of the layer's height, not of the nozzle.
    [[nodiscard]] bool width_is_of_layer() const { return !of_orca() && slicer_ != Slicer::super; }

    // The item of the extruder that prints perimeters, without quotes; "" for a key that is missing or nil.
    [[nodiscard]] std::string text(const std::string& key) const;
    [[nodiscard]] bool percent(const std::string& key) const { return text(key).ends_with('%'); }
    // Without its '%'.  Throws Error(usage) if it is no number.
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] double number_or(const std::string& key, double otherwise) const;

    // A percentage of the value of row.of, or of that key's default.
    [[nodiscard]] double share_of(const std::string& key, const SettingRow& row) const;
    // mm/s; 0: the slicer chooses it.
    [[nodiscard]] double speed(const std::string& key, const SettingRow& row, int depth = 0) const;
    // %; Slic3r kept shares, .4 for 40 %, and PrusaSlicer still reads them so.
    [[nodiscard]] double density(const std::string& key) const;
    // Whether the filament has a value of its own for what this key says of the printer.
    [[nodiscard]] bool overridden(const std::string& key, const SettingRow& row) const;

  private:
    Slicer slicer_;
    std::map<std::string, std::string> values_;
    std::size_t extruder_ = 0; // from 0
};

} // namespace filum::app::filum
