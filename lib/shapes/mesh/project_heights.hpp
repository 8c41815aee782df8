// What a slicer's project asks for by height: pauses, changes of colour, G-code, layer heights and settings.
#pragma once

#include "archive/zip.hpp"
#include "base/note.hpp"

#include <string>
#include <vector>

namespace filum::mesh {

// G-code that a project has at a height.
struct HeightCode {
    enum class Kind : std::uint8_t { colour, pause, tool, custom };
    double z = 0; // mm: the top of the layer before which it runs
    Kind what = Kind::custom;
    std::string code; // of `custom`, in the macro language of the slicer
};

// The codes by height on a plate, counted from 1, lowest first; of PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu
// Studio. Codes that cannot be read are left out.
std::vector<HeightCode> codes_by_height(archive::Zip& zip, int plate);

// Notes on what a project has by height and Filum does not follow: layer heights, settings, brim ears; and on its
// codes, which hold only as far as --pause-at repeats them.
Notes tell_heights(archive::Zip& zip, int plate);

} // namespace filum::mesh
