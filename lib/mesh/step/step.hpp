// STEP files (ISO 10303-21) as meshes, by OpenCASCADE: a program beside the commands, which a build has if it found the
// library, reads them; so a command neither loads it without need nor dies of it.
#pragma once

#include "mesh/read.hpp"

namespace filum::mesh::step {

// How far triangles may be from the faces that they stand for.
struct Tessellation {
    double deflection = 0.02; // mm, between a chord and its curve
    double angle_deg = 10;    // between neighbouring chords of a curve
};

// Whether this build can read STEP files.
bool available();

// The mesh in `bytes`: of a STEP file by its faces, else as mesh::read, of plate `plate` of a project.  Of STEP: in mm,
// whatever unit the file states; every shape in it, where its assembly puts it; faces that share an edge share its
// vertices; mesh.faces numbers CAD faces in the order of the file, from 1.  Notes tell of faces that could not be read
// or meshed. Throws Error as mesh::read; truncated if the file has no end, bad_input if OpenCASCADE cannot read it or
// finds no face in it, failure if this build cannot read STEP.
mesh::File read(std::string_view bytes, const std::string& name, const Tessellation& how = {}, int plate = 1);

} // namespace filum::mesh::step
