// The values that Cura has for all of its settings, by one rule.
#pragma once

#include "app/filum/cura_formula.hpp"
#include "app/filum/slicer_file.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace filum::app::filum {

// Looks up settings of Cura.  The value of a key is the first one of these:
//   1. that of the file: a plain value, or a formula, which is calculated
//   2. that of the definition from which all inherit, if it lies beside the file (SlicerFile::beneath)
//   3. Cura's usual value, or usual share of another key (columns `of` and `usual` of cura.tsv)
class CuraStack {
  public:
    explicit CuraStack(const SlicerFile& file);

    // Whether the file has the key, with a value that is known.
    [[nodiscard]] bool has(const std::string& key) const;
    // Whether the file has the key at all.
    [[nodiscard]] bool in_file(const std::string& key) const { return own_.contains(key) || beneath_.contains(key); }
    // The value; MissingValue if none is known, with the reason.
    [[nodiscard]] CuraValue value(const std::string& key) const;
    // The same as text; "" if it is not known.
    [[nodiscard]] std::string text(const std::string& key) const;
    // The number; none if it is not known, or no number.
    [[nodiscard]] std::optional<double> number(const std::string& key) const;

  private:
    [[nodiscard]] CuraValue looked_up(const std::string& key) const;
    [[nodiscard]] CuraValue of_setting(const SlicerSetting& setting) const;

    std::map<std::string, SlicerSetting> own_, beneath_;
    mutable std::map<std::string, CuraValue> known_; // values that were asked for
    mutable std::set<std::string> open_;             // keys that are being calculated
};

// Replaces the formulas of Cura's settings by their values.  Where one cannot be calculated, the plain default counts,
// with a remark; a formula without one stays as it is.  Adds the speeds that Cura makes of those in the file, with a
// remark.
void calculate_formulas(SlicerFile& file);

} // namespace filum::app::filum
