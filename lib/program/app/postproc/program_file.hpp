// The file of a program.  The ending of its name gives the form: text, binary G-code (.bgcode), or a print file of
// Bambu Studio (.gcode.3mf).
#pragma once

#include "app/postproc/thumbnails.hpp"
#include "archive/print_file.hpp"
#include "bgcode/file.hpp"
#include "machine/profile.hpp"
#include "postproc/about.hpp"
#include "stream/sink.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace filum::app::postproc {

class ProgramFile {
  public:
    // Throws Error(usage) for a .bgcode or .gcode.3mf if the machine does not read G-code, and for any other .3mf.
    ProgramFile(const std::string& path, const machine::Profile& profile);

    // True if requested pictures go into a table of the file; false if they are comments of the program.
    [[nodiscard]] bool tables() const { return form_ == Form::binary; }
    // The sizes of the pictures that the form of the file requires.
    [[nodiscard]] std::vector<PictureSize> own_pictures() const;
    void write(std::string_view text);
    // Fills the tables of the file: the machine, time and material of the print, the places of its parts after a move
    // by `shift` (mm), and the stages that made it.
    void describe(const machine::Profile& profile, const filum::postproc::FirstPass& first_pass, geom::Vec2 shift,
                  const std::vector<filum::postproc::Stage>& stages);
    // Adds a picture (PNG): one of own_pictures(), in their order, or one for a table.
    void add(const PictureSize& size, const std::string& png);
    void commit();

  private:
    enum class Form : std::uint8_t { text, binary, print_file };
    static Form form_of(const std::string& path, const machine::Profile& profile);
    Form form_;
    stream::Sink sink_;
    bgcode::File file_;
    archive::PrintFile print_file_;
};

} // namespace filum::app::postproc
