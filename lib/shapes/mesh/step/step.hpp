// Reads STEP files (ISO 10303-21) as meshes, by OpenCASCADE. A separate program does this, which a build contains if it
// found the library. So commands do not load the library without need, and survive its crashes.
#pragma once

#include "mesh/read.hpp"

namespace filum::mesh::step {

// Largest deviation of the triangles from the CAD faces.
struct Tessellation {
    double deflection = 0.02; // mm, between a chord and its curve
    double angle_deg = 10;    // between neighbouring chords of a curve
};

// True if this build can read STEP files.
bool available();

// Reads a mesh from `bytes`: a STEP file by its faces, any other file as mesh::read does, with plate `plate` of a
// project.
//
// The mesh of a STEP file is in mm, for every unit that the file may state. It holds every shape, at the position that
// its assembly gives it. Faces that share an edge share its vertices. mesh.faces numbers the CAD faces in the order of
// the file, from 1. Notes report faces that could not be read or meshed.
//
// Throws Error as mesh::read does; for STEP: truncated if the file has no end, bad_input if OpenCASCADE cannot read it
// or finds no face, failure if this build cannot read STEP.
mesh::File read(std::string_view bytes, const std::string& name, const Tessellation& how = {}, int plate = 1);

} // namespace filum::mesh::step
