#include "app/filum/slicer_values.hpp"

#include "app/filum/cura_file.hpp"
#include "app/filum/slicer_text.hpp"
#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <sstream>

namespace filum::app::filum {

namespace {

constexpr int kDeepestShare = 8; // most percentages that refer to each other

} // namespace

SlicerValues::SlicerValues(const SlicerFile& file) : slicer_(file.slicer) {
    for (const SlicerSetting& s : file.settings)
        if (slicer_ != Slicer::cura || !is_formula(s.value)) values_[s.key] = s.value;
    for (const char* key : {"perimeter_extruder", "wall_filament"})
        if (values_.contains(key)) extruder_ = static_cast<std::size_t>(std::clamp(number_or(key, 1), 1.0, 64.0)) - 1;
}

std::string SlicerValues::text(const std::string& key) const {
    const auto at = values_.find(key);
    if (at == values_.end()) return "";
    std::istringstream items(at->second);
    std::string first, item;
    for (std::size_t i = 0; std::getline(items, item, at->second.find(';') != std::string::npos ? ';' : ','); ++i) {
        if (i == 0) first = item;
        if (i == extruder_) first = item;
    }
    first = unquoted(first);
    return first == "nil" ? "" : first;
}

std::string SlicerValues::whole(const std::string& key) const {
    const auto at = values_.find(key);
    return at == values_.end() ? "" : at->second;
}

double SlicerValues::number(const std::string& key) const {
    const std::string value = text(key);
    return parse_number(value.ends_with('%') ? value.substr(0, value.size() - 1) : value, key);
}

double SlicerValues::number_or(const std::string& key, double otherwise) const {
    return text(key).empty() ? otherwise : number(key);
}

double SlicerValues::share_of(const std::string& key, const SettingRow& row) const {
    const std::string base(row.of);
    const SettingRow its = row_of(base, slicer_);
    const double usual = its.usual.empty() ? 0 : parse_number(std::string(its.usual), base);
    return number(key) / 100 * number_or(base, usual);
}

double SlicerValues::speed(const std::string& key, const SettingRow& row, int depth) const {
    const std::string value = text(key).empty() ? std::string(row.usual) : text(key);
    if (value.empty()) return 0;
    if (!value.ends_with('%')) return parse_number(value, key);
    if (row.of.empty() || depth > kDeepestShare) throw Error(Exit::usage, "nothing says what it is a percentage of");
    const std::string base(row.of);
    const double share = parse_number(value.substr(0, value.size() - 1), key) / 100;
    return share * speed(base, row_of(base, slicer_), depth + 1);
}

double SlicerValues::density(const std::string& key) const {
    const double value = number(key);
    return percent(key) || of_orca() || slicer_ == Slicer::cura || value > 1 ? value : 100 * value;
}

bool SlicerValues::overridden(const std::string& key, const SettingRow& row) const {
    const std::string own = "filament_" + key;
    return !key.starts_with("filament_") && row_of(own, slicer_).target == row.target && !text(own).empty();
}

} // namespace filum::app::filum
