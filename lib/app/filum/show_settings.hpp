// filum settings FILE: what Filum makes of a slicer's settings.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Prints the settings of each file in four groups: used, with our options; not followed, which can do harm; not used
// yet; without meaning here.  Returns the exit code.  Throws Error as slicer_file.
int show_settings(const std::vector<std::string>& files);

} // namespace filum::app::filum
