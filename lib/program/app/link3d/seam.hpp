// Strokes that begin on the painted faces of a slicer's project.
#pragma once

#include "cli/command.hpp"
#include "link3d/options.hpp"

#include <memory>
#include <string>

namespace filum::app::link3d {

// Makes strokes begin on the faces that the project `file` has painted for seams (--seam-in).  It is read when the
// header of the input is known, since that says where the part stands.
class PaintedSeams {
  public:
    // `how` and `io` get what the project asks for.
    PaintedSeams(const std::string& file, filum::link3d::Options& how, cli::Io& io);
    [[nodiscard]] const cli::ScanBegin& begin() const { return begin_; }

  private:
    cli::ScanBegin begin_;
};

} // namespace filum::app::link3d
