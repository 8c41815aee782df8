// The file that a program becomes, by the ending of its name: text, or binary G-code (.bgcode).
#pragma once

#include "app/postproc/thumbnails.hpp"
#include "bgcode/file.hpp"
#include "machine/profile.hpp"
#include "postproc/about.hpp"
#include "stream/sink.hpp"

#include <string>
#include <string_view>

namespace filum::app::postproc {

class ProgramFile {
  public:
    // Throws Error(usage) for a .bgcode of a machine that reads no G-code, and for a .3mf.
    ProgramFile(const std::string& path, const machine::Profile& profile);

    [[nodiscard]] bool binary() const { return binary_; }
    void write(std::string_view text);
    // What the tables of binary G-code say: the machine, what the print takes, how it was made.
    void describe(const machine::Profile& profile, const filum::postproc::FirstPass& first_pass,
                  const std::vector<filum::postproc::Stage>& stages);
    void add(const PictureSize& size, const std::string& png);
    void commit();

  private:
    bool binary_;
    stream::Sink sink_;
    bgcode::File file_;
};

} // namespace filum::app::postproc
