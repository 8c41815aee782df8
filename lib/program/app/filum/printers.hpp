// Finds printers and filaments by their names: those of Filum's profiles and those of slicers' presets.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Names as the user gives them; "": not given.
struct PrinterNames {
    std::string printer, print, filament; // --printer, --print-profile, --filament
    [[nodiscard]] bool any() const { return !printer.empty() || !print.empty() || !filament.empty(); }
    [[nodiscard]] std::vector<std::string> words() const; // as options: --printer=NAME, ...
    bool take(const std::string& word);                   // keeps the value of such an option; false: another word
};

struct ChosenPrinter {
    std::vector<std::string> words;   // --machine=NAME if the printer is a profile of Filum's, else empty
    std::vector<SlicerFile> settings; // of the presets that the names choose
};

// Finds what the names mean.  A name is first the exact name of a profile of Filum's or of a preset.  If there is none,
// it means the preset whose name holds all words of it, in upper or lower case.  If several presets match, the shortest
// name is taken, provided that all others begin with it (variants of one printer).  The filaments pla, petg, abs and
// tpu need no preset. Throws Error(usage) for a name that is unknown or ambiguous.
ChosenPrinter chosen_printer(const PrinterNames& names);

// filum printers [WORD...]: lists printers whose names or descriptions hold all words.  With --names as the first word
// it prints and searches the names alone.  Returns the exit code.  Throws Error(usage) if no printer matches.
int show_printers(const std::vector<std::string>& words);

inline constexpr const char* kPrintersHelp =
    "usage: filum printers [WORD...]\n\nLists the printers that --printer knows, or those whose names hold all words: "
    "Filum's own, and those\nof the presets of PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu Studio on this machine. "
    "FILUM_PRESETS\nnames further folders of presets, with ':' between.\n\n"
    "  filum printers mk3s\n"
    "  filum print part.stl --printer mk3s --filament petg -o part.gcode\n";

} // namespace filum::app::filum
