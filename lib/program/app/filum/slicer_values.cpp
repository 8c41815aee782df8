#include "app/filum/slicer_values.hpp"

#include "app/filum/cura_file.hpp"
#include "app/filum/slicer_text.hpp"
#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace filum::app::filum {

namespace {

constexpr int kDeepestShare = 8; // most percentages that refer to each other

constexpr double kHottest = 1000; // degrees C: more than any nozzle bears

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

bool is_one_number(const preset::Key& key) {
    using preset::Type;
    return !key.list && (key.type == Type::whole || key.type == Type::number || key.type == Type::percent ||
                         key.type == Type::share);
}

// Whether the text is a list whose items differ.
bool differs_within(const std::string& list) {
    std::istringstream items(list);
    std::string first, item;
    std::getline(items, first, ',');
    while (std::getline(items, item, ','))
        if (trimmed(item) != trimmed(first)) return true;
    return false;
}

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
    return std::round(number(key) / 100 * number_or(base, usual) * 1e6) / 1e6; // without rounding errors
}

double SlicerValues::speed(const std::string& key, const SettingRow& row, int depth) const {
    const std::string value = text(key).empty() ? std::string(row.usual) : text(key);
    if (value.empty()) return 0;
    if (!value.ends_with('%')) return parse_number(value, key);
    if (row.of.empty() || depth > kDeepestShare) throw Error(Exit::usage, "nothing says what it is a percentage of");
    const std::string base(row.of);
    const double share = parse_number(value.substr(0, value.size() - 1), key) / 100;
    const double whole = speed(base, row_of(base, slicer_), depth + 1);
    if (!(whole > 0)) throw Error(Exit::usage, "it is a percentage of " + base + ", which has no speed");
    return share * whole;
}

double SlicerValues::density(const std::string& key) const {
    const double value = number(key);
    return percent(key) || of_orca() || slicer_ == Slicer::cura || value > 1 ? value : 100 * value;
}

void SlicerValues::check(const std::string& key, const SettingRow& row) const {
    const auto refuse = [](const std::string& why) { throw Error(Exit::usage, why); };
    const std::string value = text(key);
    const preset::Key* type = preset::key_of(key);
    if (type != nullptr && is_one_number(*type) && !of_orca() && slicer_ != Slicer::cura && differs_within(whole(key)))
        refuse("it is a list, and the setting is one number; write decimals with a point");
    const bool of_nothing = row.of.empty() || row.reading == "shell"; // whose other key is a least thickness
    if (percent(key) && of_nothing && type != nullptr &&
        (type->type == preset::Type::number || type->type == preset::Type::whole))
        refuse("it is a percentage, and nothing says of what");
    if (type != nullptr && type->type == preset::Type::flag && slicer_ != Slicer::cura && value != "0" && value != "1")
        refuse("it is a switch: write 0 or 1");
    const auto number = plain_number(value.ends_with('%') ? value.substr(0, value.size() - 1) : value);
    if (!number) return;
    if (*number < 0 &&
        is_one_of(row.reading, {"number", "count", "shell", "share", "positive", "supported", "speed", "first_speed",
                                "key_positive", "celsius", "acceleration", "first_acceleration"}))
        refuse("it is negative");
    if (*number == 0 && is_one_of(row.target, {"extrusion.diameter", "extrusion.flow"}))
        refuse("it must be greater than 0");
    if (*number > kHottest && row.reading == "celsius") refuse("no nozzle is so hot");
}

bool SlicerValues::overridden(const std::string& key, const SettingRow& row) const {
    const std::string own = "filament_" + key;
    return !key.starts_with("filament_") && row_of(own, slicer_).target == row.target && !text(own).empty();
}

void refuse_decimal_commas(const SlicerFile& file, const std::string& name) {
    if (file.slicer == Slicer::orca || file.slicer == Slicer::bambu || file.slicer == Slicer::cura) return;
    for (const SlicerSetting& s : file.settings) {
        const preset::Key* type = preset::key_of(s.key);
        if (type == nullptr || !is_one_number(*type) || type->type == preset::Type::whole) continue;
        std::string value = unquoted(s.value);
        if (value.ends_with('%')) value.pop_back();
        const auto comma = value.find(',');
        if (comma == std::string::npos || !differs_within(value)) continue;
        value[comma] = '.';
        if (plain_number(value))
            throw Error(Exit::bad_input, "cannot use '" + name + "': its numbers have decimal commas (" + s.key +
                                             " = " + s.value + "); write them with points");
    }
}

} // namespace filum::app::filum
