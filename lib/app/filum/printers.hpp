// Printers and filaments by their names: Filum's own, and those of slicers' presets.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// Names as the user gives them; "": none.
struct PrinterNames {
    std::string printer, print, filament; // --printer, --print-profile, --filament
    [[nodiscard]] bool any() const { return !printer.empty() || !print.empty() || !filament.empty(); }
    [[nodiscard]] std::vector<std::string> words() const; // the options that give them
    bool take(const std::string& word);                   // such an option; false: it is none
};

struct ChosenPrinter {
    std::vector<std::string> words;   // options of `print`, where Filum has a profile of that name
    std::vector<SlicerFile> settings; // of presets
};

// A name is that of one of Filum's profiles or of a preset; else the words in it choose the preset whose name holds all
// of them, whatever their case: of variants of one printer that with the shortest name, which the others begin with.
// Filaments are those of the presets, and pla, petg, abs and tpu.
// Throws Error(usage) for a name that is unknown, or that several presets answer to.
ChosenPrinter chosen_printer(const PrinterNames& names);

// filum printers [WORD...]: lists printers whose names hold all words; with --names as the first word the names alone.
int show_printers(const std::vector<std::string>& words);

inline constexpr const char* kPrintersHelp =
    "usage: filum printers [WORD...]\n\nLists the printers that --printer knows, or those whose names hold all words: "
    "Filum's own, and those\nof the presets of PrusaSlicer, SuperSlicer, OrcaSlicer and Bambu Studio on this machine. "
    "FILUM_PRESETS\nnames further folders of presets, with ':' between.\n\n"
    "  filum printers mk3s\n"
    "  filum print part.stl --printer mk3s --filament petg -o part.gcode\n";

} // namespace filum::app::filum
