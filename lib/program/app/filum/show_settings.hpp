// `filum settings FILE`: shows how Filum translates the settings of a slicer.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

// Prints the settings of each file in groups: used, with the options of Filum; not followed although that can do harm;
// not used yet; not known; without meaning here.  With --machine as the first word it prints the machine profile of the
// printer that the files describe.  Returns the exit code.  Throws Error as slicer_file; bad_input for files without a
// printer.
int show_settings(const std::vector<std::string>& files);

} // namespace filum::app::filum
