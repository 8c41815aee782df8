#include "app/filum/slicer_table.hpp"

#include "base/table.hpp"

#include <vector>

// The assembler embeds the file FILUM_SETTINGS, which the build names, between two labels.
__asm__(".section .rodata\n.global filum_settings\nfilum_settings:\n.incbin \"" FILUM_SETTINGS
        "\"\n.global filum_settings_end\nfilum_settings_end:\n.byte 0\n.previous\n");
extern "C" const char filum_settings[], filum_settings_end[];

namespace filum::app::filum {

namespace {

struct Line {
    std::string_view key, slicers;
    SettingRow row;
};

Use use_of(std::string_view word) {
    return word == "used" ? Use::used : word == "none" ? Use::none : word == "harm" ? Use::harm : Use::later;
}

std::vector<Line> lines() {
    std::vector<Line> out;
    const std::string_view all(filum_settings, static_cast<std::size_t>(filum_settings_end - filum_settings));
    for (const auto& row : table_rows(all))
        out.push_back(
            {row.at(0), row.at(1), {use_of(row.at(2)), row.at(3), row.at(4), row.at(5), row.at(6), row.at(7)}});
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

bool has_word(std::string_view list, std::string_view word) {
    while (!list.empty())
        if (cut(list, ',') == word) return true;
    return false;
}

std::string_view word_of(Slicer slicer) {
    constexpr std::string_view kWords[] = {"unknown", "slic3r", "prusa", "super", "orca", "bambu"};
    return kWords[static_cast<std::size_t>(slicer)];
}

const std::vector<Line>& table() {
    static const std::vector<Line> all = lines();
    return all;
}

} // namespace

SettingRow row_of(std::string_view key, Slicer slicer) {
    for (const Line& line : table())
        if (fits(key, line.key) && (line.slicers == "*" || has_word(line.slicers, word_of(slicer)))) return line.row;
    return {};
}

std::vector<SlicerSetting> defaults_of(Slicer slicer) {
    std::vector<SlicerSetting> out;
    for (const Line& line : table())
        if (line.row.use == Use::used && !line.row.usual.empty() && has_word(line.slicers, word_of(slicer)))
            out.push_back({std::string(line.key), std::string(line.row.usual)});
    return out;
}

} // namespace filum::app::filum
