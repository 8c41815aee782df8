// The words of slicers in ours: options of `filum print` by the names that PrusaSlicer, Cura and others have for them,
// and their files of settings.
#pragma once

#include "app/filum/slicer_machine.hpp"
#include "app/filum/stage.hpp"

#include <memory>
#include <string>
#include <vector>

namespace filum::app::filum {

struct Translated {
    std::vector<std::string> words; // as `route` takes them
    // Settings of files that say something, but are not used here, in the file's order; first those without which a
    // print can go wrong: "start_gcode", ...
    std::vector<std::string> harmful, left;
    std::vector<std::string> remarks; // on what else of files is left out
    // Where the files describe a printer, and no --machine names another one: its profile, which `words` name.
    std::shared_ptr<SlicerMachine> machine{};
};

// The words with each --load FILE replaced by what of its settings has a meaning here, before all others, so that these
// win; and options that no stage has by that name, but that a slicer has, by ours: --fill-density 15% becomes
// --infill=15%, --temperature 210 --set=nozzle_temp=210, --rotate 45 --rotate=0,0,45, --scale 150% --scale=1.5.  All
// --set become one.  What stands behind "--" stays.  Throws Error: usage for a value that does not fit or is missing,
// io for a file that cannot be read, bad_input for one without settings.
Translated translated(const std::vector<std::string>& words, const std::vector<Stage>& stages);

} // namespace filum::app::filum
