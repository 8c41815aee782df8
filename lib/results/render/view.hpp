// Directions that pictures are taken from, and several pictures in one.
#pragma once

#include "render/canvas.hpp"

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

using Draw = std::function<void(Canvas& cell, const ViewDirection& look)>;

// A single look fills the page. Several looks are drawn in a grid, each with its name, in cells as near to 4 : 3 as
// possible.
void contact_sheet(Canvas& page, const std::vector<ViewDirection>& looks, const Draw& draw);

} // namespace filum::render
