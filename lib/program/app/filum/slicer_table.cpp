#include "app/filum/slicer_table.hpp"

namespace filum::app::filum {

std::string_view table_word(Slicer slicer) {
    constexpr std::string_view kWords[] = {"unknown", "slic3r", "prusa", "super", "orca", "bambu", "cura"};
    return kWords[static_cast<std::size_t>(slicer)];
}

SettingRow row_of(std::string_view key, Slicer slicer) { return preset::row_of(key, table_word(slicer)); }

std::vector<SlicerSetting> defaults_of(Slicer slicer) {
    std::vector<SlicerSetting> out;
    for (const SettingRow& row : preset::setting_rows())
        if (row.use == Use::used && !row.usual.empty() && row.slicers != "*" && is_for(row, table_word(slicer)))
            out.push_back({std::string(row.key), std::string(row.usual)});
    return out;
}

} // namespace filum::app::filum
