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
};

// The settings of a file, in its order (of JSON, by key): lines "name = value", as PrusaSlicer and SuperSlicer export
// them; a JSON object, as OrcaSlicer and Bambu Studio do; a project of any of them (3MF) that holds one of both; or the
// comments of a G-code file, where these slicers write theirs down.
// Throws Error: io for a file that cannot be read, bad_input for one without settings, and for a bundle of presets.
SlicerFile slicer_file(const std::string& file);

// What a file holds beside its part and its settings; nothing of one that holds no part, or is no project.
struct ProjectBodies {
    bool modifiers = false;                // bodies with settings of their own
    bool wanted = false, unwanted = false; // bodies or painted faces that ask for supports, or for none
};
ProjectBodies project_bodies(const std::string& file);

} // namespace filum::app::filum
