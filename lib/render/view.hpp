// From where pictures are taken, and several pictures in one.
#pragma once

#include "render/image.hpp"

#include <functional>
#include <string>
#include <vector>

namespace filum::render {

struct Look {
    std::string name;
    geom::Vec3 from;             // direction from the part to the camera
    bool face = false;           // instead: straight onto what is shown, along its mean normal,
    double aside = 0, above = 0; // or leaning from there to the picture's right and up: tangents of the angles
};

// Looks apart by commas: names (iso, top, bottom, front, back, left, right, face, face-left, face-right, face-up,
// face-down) and directions of three numbers.
// Throws Error(usage) naming the option --`option`.
std::vector<Look> looks(const std::string& list, const std::string& option);

using Draw = std::function<Image(const Look& look, int width, int height)>;

// One picture of width x height: that of the only look, or one per look side by side in rows, each with its name; cells
// as near to 4 : 3 as rows and columns allow.
Image contact_sheet(const std::vector<Look>& looks, int width, int height, const Draw& draw);

} // namespace filum::render
