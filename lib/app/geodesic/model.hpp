// The surface that a command works on: read from a mesh file or from a Surface stream, shaped, written.
#pragma once

#include "cli/command.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "surface/sheet.hpp"

namespace filum::app::geodesic {

struct Model {
    surface::Sheet sheet;
    Notes notes;                          // to be written: what was repaired, left out or moved
    bool step = false;                    // it comes from a STEP file
    std::vector<std::uint32_t> of_file{}; // as mesh::Mesh has it; empty: vertices are numbered as in the file
    cli::Whole before;                    // of the stream it came by: its header, notes and facts; of a mesh file none
};

// A file's content.  What it is enters self.settings as `setting`, a checksum; its name does not.
mesh::Bytes load(const std::string& path, const char* setting, cli::Io& self);

// The mesh in a file, placed, with what was left out noted.  Throws as mesh::step::read and mesh::place.
mesh::Mesh read_mesh(const std::string& path, const char* setting, mesh::Placement place, cli::Io& self, Notes& notes,
                     const mesh::step::Tessellation& how = {});

// The model in `self.input`, which is a Surface stream if its first bytes say so, else a mesh file; of that
// "input_crc32c" enters self.settings.  A stream is in mm and placed already.
// Throws Error as mesh::step::read, mesh::place, surface::connect, stream::Reader and wire::sheet; usage if a stream is
// to be placed.
Model read(const mesh::Placement& place, cli::Io& self, const mesh::step::Tessellation& how = {});

// Writes the model: what came by the stream, then its notes and `facts` as this program's, then the sheet.  Facts of
// the same program and name that came by the stream are left out: they speak of what it was before.
void write(const Model& model, const Facts& facts, const cli::Io& self);

} // namespace filum::app::geodesic
