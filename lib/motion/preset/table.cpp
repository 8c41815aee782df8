#include "preset/table.hpp"

#include "base/table.hpp"

#include <algorithm>
#include <array>
#include <utility>

// The assembler embeds the file between two labels.  The build defines FILUM_PRESET_KEYS.
__asm__(".section .rodata\n.global filum_preset_keys\nfilum_preset_keys:\n.incbin \"" FILUM_PRESET_KEYS
        "\"\n.global filum_preset_keys_end\nfilum_preset_keys_end:\n.byte 0\n.previous\n");
extern "C" const char filum_preset_keys[], filum_preset_keys_end[];

namespace filum::preset {

namespace {

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

std::vector<Key> read() {
    std::vector<Key> out;
    const std::string_view all(filum_preset_keys, static_cast<std::size_t>(filum_preset_keys_end - filum_preset_keys));
    for (const auto& row : table_rows(all)) {
        Key key{.name = row.at(0), .type = Type::text, .list = false, .of = row.at(2), .usual = row.at(3)};
        set_type(row[1], key);
        out.push_back(key);
    }
    std::ranges::sort(out, {}, &Key::name);
    return out;
}

} // namespace

const std::vector<Key>& keys() {
    static const std::vector<Key> all = read();
    return all;
}

const Key* key_of(std::string_view name) {
    const auto& all = keys();
    const auto found = std::ranges::lower_bound(all, name, {}, &Key::name);
    return found != all.end() && found->name == name ? &*found : nullptr;
}

} // namespace filum::preset
