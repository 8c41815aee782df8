#include "preset/table.hpp"

#include "base/embed.hpp"
#include "base/table.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

FILUM_EMBED(settings, FILUM_SETTINGS);
FILUM_EMBED(cura, FILUM_CURA);

namespace filum::preset {

namespace {

// The columns of the table.
enum Column : std::uint8_t {
    at_key,
    at_slicers,
    at_type,
    at_of,
    at_usual,
    at_orca,
    at_use,
    at_target,
    at_reading,
    at_why
};

using Cells = std::vector<std::vector<std::string_view>>;

const Cells& cells() {
    static const Cells all = [] {
        Cells out = table_rows(FILUM_EMBEDDED(settings));
        std::ranges::move(table_rows(FILUM_EMBEDDED(cura)), std::back_inserter(out));
        return out;
    }();
    return all;
}

// Sets the type of a key.  "floats" is a list of "float".
void set_type(std::string_view word, Key& to) {
    constexpr std::array<std::pair<std::string_view, Type>, 8> kTypes{{{"flag", Type::flag},
                                                                       {"int", Type::whole},
                                                                       {"float", Type::number},
                                                                       {"percent", Type::percent},
                                                                       {"share", Type::share},
                                                                       {"text", Type::text},
                                                                       {"word", Type::word},
                                                                       {"point", Type::point}}};
    to.list = word.ends_with('s');
    if (to.list) word.remove_suffix(1);
    for (const auto& [name, type] : kTypes)
        if (name == word) to.type = type;
}

Use use_of(std::string_view word) {
    return word == "used" ? Use::used : word == "none" ? Use::none : word == "harm" ? Use::harm : Use::later;
}

std::vector<SettingRow> read_rows() {
    std::vector<SettingRow> out;
    for (const auto& row : cells())
        out.push_back({.key = row.at(at_key),
                       .slicers = row.at(at_slicers),
                       .of = row.at(at_of),
                       .usual = row.at(at_usual),
                       .use = use_of(row.at(at_use)),
                       .target = row.at(at_target),
                       .reading = row.at(at_reading),
                       .why = row.at(at_why)});
    return out;
}

// A key has one type in all slicers.  Its default of OrcaSlicer is in the cell for it, or in a row for OrcaSlicer
// alone.
std::vector<Key> read_keys() {
    std::vector<Key> out;
    std::map<std::string_view, std::string_view> orca;
    for (std::size_t i = 0; i < cells().size(); ++i) {
        const auto& row = cells()[i];
        const bool own = is_for(setting_rows()[i], "orca") && !is_for(setting_rows()[i], "prusa");
        if (const auto value = own ? row[at_usual] : row[at_orca]; !value.empty()) orca[row[at_key]] = value;
    }
    for (std::size_t i = 0; i < cells().size(); ++i) {
        const std::string_view type = cells()[i][at_type];
        if (type.empty()) continue;
        const SettingRow& row = setting_rows()[i];
        Key key{.name = row.key, .type = Type::text, .list = false, .of = row.of, .usual = {}, .orca = {}};
        if (is_for(row, "prusa")) key.usual = row.usual;
        if (const auto found = orca.find(row.key); found != orca.end()) key.orca = found->second;
        set_type(type, key);
        out.push_back(key);
    }
    std::ranges::sort(out, {}, &Key::name);
    return out;
}

// Whether a key matches the pattern; each * in it stands for any text.
bool fits(std::string_view key, std::string_view pattern) {
    const auto star = pattern.find('*');
    if (star == std::string_view::npos) return key == pattern;
    if (!key.starts_with(pattern.substr(0, star))) return false;
    const std::string_view rest = pattern.substr(star + 1);
    for (std::size_t i = star; i <= key.size(); ++i)
        if (fits(key.substr(i), rest)) return true;
    return false;
}

} // namespace

const std::vector<Key>& keys() {
    static const std::vector<Key> all = read_keys();
    return all;
}

const Key* key_of(std::string_view name) {
    const auto& all = keys();
    const auto found = std::ranges::lower_bound(all, name, {}, &Key::name);
    return found != all.end() && found->name == name ? &*found : nullptr;
}

const std::vector<SettingRow>& setting_rows() {
    static const std::vector<SettingRow> all = read_rows();
    return all;
}

bool is_for(const SettingRow& row, std::string_view slicer) {
    if (row.slicers == "*") return slicer != "cura"; // its keys have meanings of their own
    for (std::string_view list = row.slicers; !list.empty();)
        if (cut(list, ',') == slicer) return true;
    return false;
}

SettingRow row_of(std::string_view key, std::string_view slicer) {
    for (const SettingRow& row : setting_rows())
        if (fits(key, row.key) && is_for(row, slicer)) return row;
    return {};
}

} // namespace filum::preset
