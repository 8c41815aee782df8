// What a slicer's project (3MF) holds besides its parts: settings, bodies, and codes by height.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The settings of the project in `bytes`: its own, then those that all parts of a plate have instead. `file` is for
// messages.
SlicerFile project_settings(const std::string& bytes, const std::string& file, int plate);

// The kinds of bodies on a plate of a slicer's project.
struct ProjectBodies {
    bool modifiers = false;                // bodies or parts with settings of their own
    bool wanted = false, unwanted = false; // bodies, parts or painted faces that ask for supports, or forbid them
    bool seams = false;                    // faces painted for seams or against them
};
// All false for a file that is no project, holds no part or cannot be read.
ProjectBodies project_bodies(const std::string& file, int plate = 1);

// The codes by height on a plate of a slicer's project.
struct ProjectCodes {
    std::string pauses;               // pauses and changes of colour, for --pause-at
    std::vector<std::string> remarks; // a sentence for each code of another kind, which is not followed
};
// `layer_height`, mm: --pause-at counts from below the layer, the project from its top. Empty for a file that is no
// project.
ProjectCodes project_codes(const std::string& file, int plate, double layer_height);

} // namespace filum::app::filum
