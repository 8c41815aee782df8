// What is known of slicers' settings by their names; the build puts keys.tsv into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace filum::preset {

// Of one value, or of each value of a list.
enum class Type : std::uint8_t {
    flag,
    whole,
    number,
    percent,
    share, // a number, or a percentage of another setting
    text,
    word, // one of a choice
    point,
};

struct Key {
    std::string_view name;
    Type type = Type::text;
    bool list = false;
    std::string_view of;    // a share: the setting that 100 % are
    std::string_view usual; // the value where a file lacks it; "" for none
};

// Null for an unknown name.
const Key* key_of(std::string_view name);
const std::vector<Key>& keys();

} // namespace filum::preset
