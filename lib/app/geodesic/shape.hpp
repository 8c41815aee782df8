// Cutting and remeshing a model, by the options that commands have for it.
#pragma once

#include "app/geodesic/model.hpp"

namespace filum::app::geodesic {

enum class Keep : std::uint8_t { outside, inside };

struct Shaping {
    std::vector<double> cut;   // nx, ny, nz, d of a plane: what lies beyond goes; none: do not
    std::string cut_mesh;      // file of a closed mesh, in mm; none: do not
    Keep keep = Keep::outside; // of that
    std::string remesh = "0";  // mm: sides of the triangles; 0: do not; "auto": as surface::fit has it, with these:
    double longest = 1;        // mm
    double tolerance = 0.02;   // mm
    bool flip = false;         // turn the surface round before all that
};

std::vector<cli::Option> options(Shaping& to);

// Turns the surface round, cuts by the plane, then by the mesh, then remeshes.  Fields and CAD faces are carried over;
// lines and sources that the sheet came with go, with a note, since their triangles do.  Returns the fact "remesh-off",
// mm: how far the surface is off by --remesh auto; a note where that is more than the tolerance. Throws Error as
// surface::cut, surface::remesh and surface::fit::fitted; usage if `remesh` is neither.
Facts shape(Model& model, const Shaping& how, const mesh::Placement& place, cli::Io& self);

} // namespace filum::app::geodesic
