// The table of slicers' settings: what their values are, and what Filum makes of them.  The build embeds settings.tsv
// and cura.tsv in the program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::preset {

// The type of one value, or of each value of a list.
enum class Type : std::uint8_t {
    flag,
    whole,
    number,
    percent,
    share, // a number, or a percentage of another setting
    text,
    word, // one word of a choice
    point,
};

struct Key {
    std::string_view name;
    Type type = Type::text;
    bool list = false;
    std::string_view of;    // of a share: the setting that is 100 %
    std::string_view usual; // default of PrusaSlicer where a file lacks the setting; "" for none
    std::string_view orca;  // the same for OrcaSlicer and Bambu Studio
};

// The entry of a setting; null for a name without a type.
const Key* key_of(std::string_view name);
const std::vector<Key>& keys();

// What Filum does with a setting.
enum class Use : std::uint8_t {
    used,
    none,   // the setting has no meaning in Filum
    later,  // the setting has a meaning, but Filum does not use it yet
    harm,   // as `later`, and a print without the setting can go wrong
    unknown // the table has no row for the setting
};

// One row of the table; a cell with '-' is empty here.
struct SettingRow {
    std::string_view key;     // a * in it stands for any text
    std::string_view slicers; // words with commas between; "*": all but cura
    std::string_view of;      // the key that a percentage refers to
    std::string_view usual;   // the slicer's default
    Use use = Use::unknown;
    std::string_view target;  // Filum's option, or a key of the machine profile
    std::string_view reading; // how the value is converted; see app/filum/slicer_settings.cpp
    std::string_view why;     // why the setting is not used
};

// All rows, in the order of the table.
const std::vector<SettingRow>& setting_rows();

// Whether a row is for a slicer, by its word ("prusa", "unknown", ...).
bool is_for(const SettingRow& row, std::string_view slicer);

// The first row that fits the key and the slicer.  Without one, a row whose `use` is Use::unknown.
SettingRow row_of(std::string_view key, std::string_view slicer);

} // namespace filum::preset
