// What the algorithms of `surfpath` make: strokes on a surface; and the toolpath that lays them.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "surface/curve/line.hpp"
#include "toolpath/path.hpp"

namespace filum::surfpath::plan {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// A stretch of a stroke.  It begins where the one before ended.
struct Piece {
    Line line;            // open
    bool hairpin = false; // a turn that is declared to be tighter than what the path keeps to elsewhere
};

// What is laid without cutting the fibre.
struct Stroke {
    std::vector<Piece> pieces;
};

struct Plan {
    std::vector<Stroke> strokes; // in the order of laying
    Notes notes;                 // what could not be placed, with place and amount
    Facts facts;
    std::vector<Vec3> births{}; // where two lines of field are born, or end, joined by a turn
};

struct Laying {
    double width = 1;         // mm, of the bead
    double height = 0.2;      // mm, of the bead
    double lift = 5;          // mm: how high the tool travels above the surface (h_r of Kipping et al. 2022)
    double offset = 0;        // mm: how far along the normal the path lies above the surface: of plies, those below
    std::uint32_t layer = 0;  // of the spans: the ply
    std::uint32_t stroke = 0; // of the first one
};

// The toolpath of a plan: beads with the surface's normals as tool axes; from the end of a stroke to the begin of the
// next up along the normal, across, and down (Kipping et al. 2022, 3.1.1).  Pieces of a stroke that do the same follow
// each other in one span.
std::vector<toolpath::Span> spans(const Surface& surface, const Plan& plan, const Laying& laying);

// Adds the same to a toolpath that has begun elsewhere, as on another surface: behind a travel from where it ended.
void add_spans(const Surface& surface, const Plan& plan, const Laying& laying, std::vector<toolpath::Span>& out);

} // namespace filum::surfpath::plan
