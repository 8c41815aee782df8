// Settings as slicers keep them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filum::app::filum {

enum class Slicer : std::uint8_t { unknown, slic3r, prusa, super, orca, bambu };

// "PrusaSlicer"; of an unknown one "a slicer that the file does not name".
const char* name_of(Slicer slicer);

struct SlicerSetting {
    std::string key, value; // as they stand in the file; the items of a list with commas between them
};

struct SlicerFile {
    Slicer slicer = Slicer::unknown; // that wrote it, as far as it says so
    std::vector<SlicerSetting> settings;
    std::vector<std::string> remarks{}; // on presets that were not found
};

// The slicer that wrote a text: by the name at its beginning, or by keys that only it has.
Slicer writer_of(const std::string& text, const std::vector<SlicerSetting>& settings);

// The settings of a file, in its order (of JSON, by key): lines "name = value", as PrusaSlicer and SuperSlicer export
// them; a JSON object, as OrcaSlicer and Bambu Studio do; a project of any of them (3MF) that holds one of both; the
// comments of a G-code file, where these slicers write theirs down; or presets of a bundle, which `word` names as in
// "FILE:printer=NAME,print=NAME,filament=NAME".  What a preset inherits is in front of its own settings.
// Throws Error: io for a file that cannot be read; bad_input for one without settings, and for a bundle of which
// nothing says which presets hold; usage for an unknown preset.
SlicerFile slicer_file(const std::string& word);

// Files that one slicer wrote, as one: a printer, a print and a filament in three files.  Later files win.
std::vector<SlicerFile> merged(std::vector<SlicerFile> files);

// What a file holds beside its part and its settings; nothing of one that holds no part, or is no project.
struct ProjectBodies {
    bool modifiers = false;                // bodies with settings of their own
    bool wanted = false, unwanted = false; // bodies or painted faces that ask for supports, or for none
};
ProjectBodies project_bodies(const std::string& file);

} // namespace filum::app::filum
