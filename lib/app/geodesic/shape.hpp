// Cutting and remeshing a model, by the options that commands have for it.
#pragma once

#include "app/geodesic/model.hpp"

namespace filum::app::geodesic {

enum class Keep : std::uint8_t { outside, inside };

struct Shaping {
    std::vector<double> cut;   // nx, ny, nz, d of a plane: what lies beyond goes; none: do not
    std::string cut_mesh;      // file of a closed mesh, in mm; none: do not
    Keep keep = Keep::outside; // of that
    double remesh = 0;         // mm: sides of the triangles; 0: do not
};

std::vector<cli::Option> options(Shaping& to);

// Cuts by the plane, then by the mesh, then remeshes.  Fields and CAD faces are carried over; lines and sources that
// the sheet came with go, with a note, since their triangles do.  Throws Error as surface::cut and surface::remesh.
void shape(Model& model, const Shaping& how, const mesh::Placement& place, cli::Io& self);

} // namespace filum::app::geodesic
