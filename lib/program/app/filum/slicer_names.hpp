// Translates the options and the settings files of slicers, such as PrusaSlicer and Cura, to options of `filum print`.
#pragma once

#include "app/filum/slicer_machine.hpp"
#include "app/filum/stage.hpp"

#include <memory>
#include <string>
#include <vector>

namespace filum::app::filum {

struct SlicerTranslation {
    std::vector<std::string> words; // as `distribute` takes them
    // Settings of the files that are not used, in the order of the files.  `harmful`: a print can go wrong without
    // them; `left`: the others.  Settings that are empty or off are in neither list.
    std::vector<std::string> harmful, left;
    std::vector<std::string> remarks; // other parts of the files that are not used or were changed, a sentence for each
    // The profile of the printer that the files describe; `words` name its file.  Null if the files describe no printer
    // or --machine names another one.
    std::shared_ptr<SlicerMachine> machine{};
};

// The words in the terms of Filum's options.
//   - The settings of each --load FILE that Filum knows become options.  They come first, so that typed options win.
//   - An option by a slicer's name becomes one of ours, if no stage has an option of that name: --fill-density 15%
//     becomes --infill=15%, and --temperature 210 becomes --set=nozzle_temp=210.
//   - Values in the form of slicers are converted: --rotate 45 to --rotate=0,0,45, --scale 150% to --scale=1.5.
//   - All --set are joined to one.  Words behind "--" stay as they are.
// Throws Error: usage for a value that does not fit or is missing, io for a file that cannot be read, bad_input for a
// file without settings.
SlicerTranslation translated(const std::vector<std::string>& words, const std::vector<Stage>& stages);

} // namespace filum::app::filum
