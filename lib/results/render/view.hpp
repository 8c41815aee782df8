// Directions that pictures are taken from, and several pictures in one.
#pragma once

#include "render/image.hpp"

#include <functional>
#include <string>
#include <vector>

namespace filum::render {

struct ViewDirection {
    std::string name;
    geom::Vec3 from; // direction from the part to the camera
    // Instead of `from`: straight at the object along its mean normal, or turned from there to the right and up in the
    // picture. `aside` and `above` are the tangents of these angles.
    bool face = false;
    double aside = 0, above = 0;
};

// Reads a list of looks separated by commas: names (iso, top, bottom, front, back, left, right, face, face-left,
// face-right, face-up, face-down) or directions of three numbers. Throws Error(usage) naming the option --`option`.
std::vector<ViewDirection> looks(const std::string& list, const std::string& option);

using Draw = std::function<Image(const ViewDirection& look, int width, int height)>;

// A picture of width x height. A single look fills it. Several looks are drawn in a grid, each with its name, in cells
// as near to 4 : 3 as possible.
Image contact_sheet(const std::vector<ViewDirection>& looks, int width, int height, const Draw& draw);

} // namespace filum::render
