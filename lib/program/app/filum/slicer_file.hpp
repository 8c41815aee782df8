// Reads the settings in files of slicers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace filum::app::filum {

enum class Slicer : std::uint8_t { unknown, slic3r, prusa, super, orca, bambu, cura };

// The name, such as "PrusaSlicer"; for Slicer::unknown "a slicer that the file does not name".
const char* name_of(Slicer slicer);

struct SlicerSetting {
    std::string key, value; // as in the file; the items of a list have commas between them
    std::string plain{};    // of a formula of Cura: the value that counts if the formula cannot be calculated
};

// The first setting with a key; null if there is none.
const SlicerSetting* find_setting(const std::vector<SlicerSetting>& all, std::string_view key);

// Gives the key the value in its place, or adds it at the end.
void put_setting(std::vector<SlicerSetting>& all, const SlicerSetting& setting);

struct SlicerFile {
    Slicer slicer = Slicer::unknown; // the slicer that wrote the file
    std::vector<SlicerSetting> settings;
    std::vector<std::string> remarks{}; // presets that were not found, a sentence for each
    // Settings of Cura's definition for all printers.  They count where others refer to them, and set nothing.
    std::vector<SlicerSetting> beneath{};

    [[nodiscard]] bool has(std::string_view key) const { return find_setting(settings, key) != nullptr; }
};

// The slicer that wrote a text.  It is known by its name in the first 16 KiB of the text, or by keys that only this
// slicer has.
Slicer writer_of(const std::string& text, const std::vector<SlicerSetting>& settings);

// The settings of a file, in its order; those of JSON are sorted by key.  The file is one of these:
//   - lines "name = value", as PrusaSlicer and SuperSlicer export them
//   - a JSON object, as OrcaSlicer and Bambu Studio export it
//   - a project (3MF) of one of these slicers
//   - a G-code file, which holds the settings as comments
//   - a profile, a printer or a project of Cura; see cura_file.hpp
//   - a bundle of presets; `word` names some of them as in "FILE:printer=NAME,print=NAME,filament=NAME"
// Settings that a preset inherits come before its own ones.
// Throws Error: io for a file that cannot be read; bad_input for a file without settings, and for a bundle if no preset
// of it is chosen; usage for an unknown preset.
// Of a project, settings that all parts of plate number `plate` have are settings of the file.
SlicerFile slicer_file(const std::string& word, int plate = 1);

// Puts the settings of `file` over those of `into`.
void put_over(SlicerFile& into, SlicerFile file);

// Joins consecutive files of the same slicer to one, such as a printer, a print and a filament.  A file of an unknown
// slicer joins any other.  Where several files have a key, the last one counts.  Formulas of Cura are calculated then.
std::vector<SlicerFile> merged(std::vector<SlicerFile> files);

} // namespace filum::app::filum
