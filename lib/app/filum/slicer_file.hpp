// Settings as slicers keep them.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

struct SlicerSetting {
    std::string key, value; // of a list, as for several extruders, the first value
};

// The settings of a file, in its order (of JSON, by key): lines "name = value", as PrusaSlicer and SuperSlicer export
// them; a JSON object, as OrcaSlicer and Bambu Studio do; or a project of any of them (3MF) that holds one of both.
// Throws Error: io for a file that cannot be read, bad_input for one without settings.
std::vector<SlicerSetting> slicer_settings(const std::string& file);

// What a file holds beside its part and its settings; nothing of one that holds no part, or is no project.
struct ProjectBodies {
    bool modifiers = false;                // bodies with settings of their own
    bool wanted = false, unwanted = false; // bodies or painted faces that ask for supports, or for none
};
ProjectBodies project_bodies(const std::string& file);

} // namespace filum::app::filum
