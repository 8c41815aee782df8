// Reads the settings in files of Cura.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <optional>
#include <string>

namespace filum::app::filum {

// Whether a value of Cura is a Python formula, such as "=line_width * 2".
bool is_formula(const std::string& value);

// The settings of a file of Cura; none if Cura did not write the file.  It is one of these:
//   - a profile: an archive (.curaprofile), or one of the files in it (.inst.cfg)
//   - a project (3MF) of Cura
//   - the definition of a printer (.def.json), with those that it inherits from and that of its first extruder, which
//     are sought in the same folder and in "extruders" beside it
//   - a G-code file, at whose end Cura writes the profile in lines ";SETTING_3 ..."
// True and False become 1 and 0.  A formula keeps its '=' until calculate_formulas().  Of the definition from which all
// others inherit, only the settings of the printer are the file's; the others are SlicerFile::beneath.
// Throws Error: io for a file that cannot be read; bad_input for a damaged archive, and for a definition that inherits
// from itself.
std::optional<SlicerFile> cura_file(const std::string& bytes, const std::string& file);

} // namespace filum::app::filum
