#include "app/filum/cura_stack.hpp"

#include "app/filum/cura_file.hpp"
#include "app/filum/slicer_table.hpp"
#include "app/filum/slicer_text.hpp"
#include "base/number.hpp"

#include <cmath>
#include <utility>

namespace filum::app::filum {

namespace {

constexpr std::size_t kDeepestName = 20; // most formulas that refer to each other; each may be nested as deep as it can

std::map<std::string, SlicerSetting> by_key(const std::vector<SlicerSetting>& all) {
    std::map<std::string, SlicerSetting> out;
    for (const SlicerSetting& s : all) out[s.key] = s;
    return out;
}

// Adds the speeds that Cura makes of those in the file.  A speed that depends on an unknown one stays unknown.
void add_speeds(SlicerFile& file) {
    const CuraStack cura(file);
    std::string added;
    for (const preset::SettingRow& row : preset::setting_rows()) {
        const bool speed = row.reading == "speed" || row.reading == "first_speed" || row.reading == "base";
        if (row.slicers != "cura" || !speed || !row.key.starts_with("s") || row.of.empty() || file.has(row.key) ||
            !file.has(row.of))
            continue;
        auto mm_s = cura.number(std::string(row.key));
        if (!mm_s) continue;
        mm_s = std::round(*mm_s * 100) / 100; // two thirds of another speed, and the like
        put_setting(file.settings, {std::string(row.key), shortest_text(*mm_s)});
        if (row.reading != "base")
            added += (added.empty() ? "" : ", ") + std::string(row.key) + " = " + shortest_text(*mm_s);
    }
    if (!added.empty()) file.remarks.push_back("speeds by Cura's usual formulas: " + added + " mm/s");
}

} // namespace

CuraStack::CuraStack(const SlicerFile& file) : own_(by_key(file.settings)), beneath_(by_key(file.beneath)) {}

bool CuraStack::has(const std::string& key) const {
    const auto own = own_.find(key);
    return own != own_.end() && !own->second.value.empty() && value(key).known();
}

CuraValue CuraStack::value(const std::string& key) const {
    if (const auto at = known_.find(key); at != known_.end()) return at->second;
    if (open_.contains(key)) return {MissingValue{"'" + key + "' depends on itself"}};
    if (open_.size() >= kDeepestName) return {MissingValue{"too many formulas refer to each other"}};
    open_.insert(key);
    CuraValue out = looked_up(key);
    open_.erase(key);
    return known_[key] = std::move(out);
}

CuraValue CuraStack::looked_up(const std::string& key) const {
    for (const auto* level : {&own_, &beneath_})
        if (const auto at = level->find(key); at != level->end() && !at->second.value.empty())
            return of_setting(at->second);
    const SettingRow row = row_of(key, Slicer::cura);
    if (row.usual.empty()) return {MissingValue{"no file has '" + key + "'"}};
    if (!row.usual.ends_with('%')) return value_of(row.usual);
    const double percent = parse_number(row.usual.substr(0, row.usual.size() - 1), key);
    CuraValue base = value(std::string(row.of));
    const auto* number = std::get_if<double>(&base.as);
    return number == nullptr ? base : percent == 100 ? base : CuraValue{percent / 100 * *number};
}

CuraValue CuraStack::of_setting(const SlicerSetting& setting) const {
    if (!is_formula(setting.value)) return value_of(setting.value);
    return calculated(std::string_view(setting.value).substr(1), [&](const std::string& name) { return value(name); });
}

std::string CuraStack::text(const std::string& key) const {
    const auto own = own_.find(key);
    if (own != own_.end() && !is_formula(own->second.value)) return own->second.value;
    const CuraValue out = value(key);
    return out.known() ? text_of(out) : "";
}

std::optional<double> CuraStack::number(const std::string& key) const { return value(key).number(); }

void calculate_formulas(SlicerFile& file) {
    const CuraStack cura(file);
    std::string replaced;
    for (SlicerSetting& s : file.settings) {
        if (!is_formula(s.value)) continue;
        const CuraValue exact = cura.value(s.key);
        if (!exact.known() && s.plain.empty()) continue;
        if (!exact.known()) replaced += (replaced.empty() ? "" : ", ") + s.key;
        s.value = exact.known() ? text_of(exact) : s.plain;
    }
    if (!replaced.empty()) file.remarks.push_back("plain values instead of formulas of Cura: " + replaced);
    add_speeds(file);
}

} // namespace filum::app::filum
