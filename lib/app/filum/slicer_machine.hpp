// A machine profile from the settings of a slicer: its bed, its firmware, its G-code.
#pragma once

#include "app/filum/folder.hpp"
#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The text of a machine profile (TOML) for the printer of these settings, "" if they describe none: neither G-code for
// its start nor the shape of its bed.  `input`: the part's file, whose name macros may ask for.
// Throws Error(bad_input) for a firmware that Filum does not write for, and for G-code with a fault in its macros.
std::string machine_of(const SlicerFile& file, const std::string& input);

// The machine profile of slicers' files, as a file for a while.
class SlicerMachine {
  public:
    // `sources`: the files as they were named.  Throws as machine_of.
    SlicerMachine(std::vector<SlicerFile> files, std::vector<std::string> sources);

    // Whether the files describe a printer.
    [[nodiscard]] bool any() const { return !path_.empty(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    // Writes the file again, for this part.
    void name_input(const std::string& input) const;
    [[nodiscard]] const std::string& text() const { return text_; }
    // What a shell has to type to get the same file, and the name that it has then.
    [[nodiscard]] std::string command() const;
    static constexpr const char* kShownName = "./slicer-machine.toml";

  private:
    void write(const std::string& text) const;
    std::string text_;
    SlicerFile file_; // all files as one; later ones win
    std::vector<std::string> sources_;
    Folder folder_;
    std::string path_;
};

} // namespace filum::app::filum
