// Reads the surface that a command works on from a mesh file or from a Surface stream, and writes it.
#pragma once

#include "cli/command.hpp"
#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "surface/sheet.hpp"

namespace filum::app::geodesic {

struct Model {
    surface::Sheet sheet;
    Notes notes;                          // notes to write: repairs, omissions and moves
    bool step = false;                    // the model comes from a STEP file
    std::vector<std::uint32_t> of_file{}; // as mesh::Mesh::of_file; empty: vertices are numbered as in the file
    cli::WholeInput before;               // header, notes and facts of the input stream; empty for a mesh file
};

// The content of a file.  Its checksum is added to self.settings under the name `setting`; its path is not.
mesh::Bytes load(const std::string& path, const char* setting, cli::Io& self);

// The mesh in a file, placed.  `notes` gets a note on each omission.  `setting`: as in load().  Throws Error as
// mesh::step::read and mesh::place.
mesh::Mesh read_mesh(const std::string& path, const char* setting, mesh::Placement place, cli::Io& self, Notes& notes,
                     const mesh::step::Tessellation& how = {});

// The model in the file self.input: a Surface stream if its first bytes say so, else a mesh.  The checksum of a mesh is
// added to self.settings as "input_crc32c".  A stream is in mm and placed already.
// Throws Error as mesh::step::read, mesh::place, surface::connect, stream::Reader and wire::sheet; usage for a stream
// if `place` asks to move it.
Model read(const mesh::Placement& place, cli::Io& self, const mesh::step::Tessellation& how = {});

// Writes the model: notes and facts of the input stream, then model.notes and `facts` as those of this program, then
// the sheet.  A fact of the input stream is left out if this program writes one of the same name again, since it
// describes the earlier surface.
void write(const Model& model, const Facts& facts, const cli::Io& self);

} // namespace filum::app::geodesic
