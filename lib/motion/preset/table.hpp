// The table of slicers' settings: their types and defaults.  The build embeds keys.tsv in the program.
#pragma once

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
    std::string_view usual; // default where a file lacks the setting; "" for none
};

// The entry of a setting; null for an unknown name.
const Key* key_of(std::string_view name);
const std::vector<Key>& keys();

} // namespace filum::preset
