// Cuts and remeshes a model, by the options that several commands share.
#pragma once

#include "app/geodesic/model.hpp"

namespace filum::app::geodesic {

enum class Keep : std::uint8_t { outside, inside };

struct Shaping {
    std::vector<double> cut;   // nx, ny, nz, d per plane: keep the side n x <= d of each; empty: no cut
    std::string cut_mesh;      // file of a closed mesh, in mm, that cuts the surface; "": no cut
    Keep keep = Keep::outside; // side of cut_mesh that remains
    std::string remesh = "0";  // mm: side length of triangles; "0": no remeshing; "auto": by surface::fit
    double longest = 1;        // mm: longest side, for "auto"
    double tolerance = 0.02;   // mm: largest distance of the new surface from the given one, for "auto"
    bool flip = false;         // turn the surface round before the other steps
};

// The options that fill `to`.
std::vector<cli::Option> options(Shaping& to);

// Turns the surface round, cuts it by the plane, then by the mesh, then remeshes it.  Fields and CAD faces are
// transferred. Isolines and sources of the sheet are dropped with a note, since their triangles no longer exist.  For
// "auto" it returns the fact "remesh-off": the largest distance of the new surface from the given one, mm.  A note
// reports a distance above the tolerance. Throws Error as surface::cut, surface::remesh and surface::fit::fitted; usage
// if `remesh` is no length and not "auto".
Facts shape(Model& model, const Shaping& how, const mesh::Placement& place, cli::Io& self);

} // namespace filum::app::geodesic
