// Makes a machine profile from the settings of a slicer: the printer's bed, firmware and G-code.
#pragma once

#include "app/filum/folder.hpp"
#include "app/filum/slicer_file.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The text of a machine profile (TOML) for the printer of these settings.  The result is "" if the settings describe no
// printer: they hold no G-code for the start and no shape of the bed.  `input`: the file of the part; macros in the
// G-code can use its name.
// Throws Error(bad_input) for a firmware that Filum does not write for, and for G-code with a fault in its macros.
std::string machine_of(const SlicerFile& file, const std::string& input);

// The machine profile of slicers' files, as a temporary file.
class SlicerMachine {
  public:
    // `sources`: the names of the files, as the user typed them.  Where several files have a key, the last one counts.
    // Throws Error as machine_of; io if the file cannot be written.
    SlicerMachine(std::vector<SlicerFile> files, std::vector<std::string> sources);

    // Whether the files describe a printer.
    [[nodiscard]] bool any() const { return !path_.empty(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    // Writes the file again, with the name of the part's file.  Throws Error as machine_of; io.
    void name_input(const std::string& input) const;
    [[nodiscard]] const std::string& text() const { return text_; }
    // The shell command that makes the same profile as the file kShownName.
    [[nodiscard]] std::string command() const;
    static constexpr const char* kShownName = "./slicer-machine.toml";

  private:
    void write(const std::string& text) const;
    std::string text_;
    SlicerFile file_; // all files joined
    std::vector<std::string> sources_;
    Folder folder_;
    std::string path_;
};

} // namespace filum::app::filum
