// A Bambu Studio print file (.gcode.3mf): a 3MF archive without a model. It holds the program of one plate, and the
// data that the printer and its software show. Entries and keys are those of BambuStudio's and OrcaSlicer's
// `bbs_3mf.cpp`.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace filum::archive {

using PlateBox = std::array<double, 4>; // mm on the bed: least x, least y, greatest x, greatest y

// A part as it stands on the plate.
struct PlatePart {
    std::string name;
    PlateBox box{};
};

// The filament that one tool uses.
struct FilamentUse {
    int tool = 0;                  // counted from 0
    double length = 0, weight = 0; // m, g
};

struct PrintFile {
    std::string gcode;
    std::string printer;     // name; that of a Bambu Lab printer adds its model id to the file
    double nozzle = 0;       // mm, diameter; 0: unknown
    double layer_height = 0; // mm
    double seconds = 0;      // duration of the print
    bool supports = false;   // the program prints supports
    std::vector<PlatePart> parts;
    std::vector<FilamentUse> filaments;
    std::string picture, small_picture; // PNG, kPlatePicture and kSmallPlatePicture pixels wide; "" for none
};

inline constexpr int kPlatePicture = 512, kSmallPlatePicture = 128;

// The bytes of the file.  Equal content gives equal bytes.
std::string written(const PrintFile& file);

} // namespace filum::archive
