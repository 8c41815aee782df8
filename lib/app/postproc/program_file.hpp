// The file that a program becomes, by the ending of its name: text, binary G-code (.bgcode), or a print file of Bambu
// Studio (.gcode.3mf).
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
    // Throws Error(usage) for a .bgcode or .gcode.3mf of a machine that reads no G-code, and for another .3mf.
    ProgramFile(const std::string& path, const machine::Profile& profile);

    // True where pictures that a user asks for go into a table of the file; elsewhere they are comments of the program.
    [[nodiscard]] bool tables() const { return form_ == Form::binary; }
    // The sizes of the pictures that the file needs of its own accord.
    [[nodiscard]] std::vector<PictureSize> own_pictures() const;
    void write(std::string_view text);
    // What the tables of the file say: the machine, what the print takes, where its parts stand after they were moved
    // by `shift`, how it was made.
    void describe(const machine::Profile& profile, const filum::postproc::FirstPass& first_pass, geom::Vec2 shift,
                  const std::vector<filum::postproc::Stage>& stages);
    // One of the pictures: of own_pictures() in their order, or of those for a table.
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
