// The result of all algorithms of `surfpath`: a plan of strokes on a surface, and its conversion to a toolpath.
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

// A part of a stroke; it begins where the one before ends.
struct Section {
    Line line;                    // open
    bool hairpin = false;         // marked as tighter than the least radius
    std::vector<double> widths{}; // mm, per place; empty: the usual width everywhere
};

// A path that is laid without cutting the fibre.
struct Stroke {
    std::vector<Section> sections;
};

struct Plan {
    std::vector<Stroke> strokes; // in the order of the path
    Notes notes;                 // what could not be placed, with place and amount
    Facts facts;
    std::vector<Vec3> births{}; // places where two lines of field begin or end together, joined by a turn
};

// Properties of the spans that a plan becomes.
struct SpanOptions {
    double width = 1;         // mm, of the bead
    double height = 0.2;      // mm, of the bead
    double lift = 5;          // mm above the surface for travels (h_r of Kipping et al. 2022)
    double offset = 0;        // mm above the surface along its normals: the thickness of the plies below
    std::uint32_t layer = 0;  // layer of all spans: the ply
    std::uint32_t stroke = 0; // number of the first stroke
};

// The toolpath of a plan: beads whose tool axes are the surface's normals. Travels from stroke to stroke lead up along
// the normal, across, and down (Kipping et al. 2022, 3.1.1). Consecutive sections of the same role become one span.
std::vector<toolpath::Span> spans(const Surface& surface, const Plan& plan, const SpanOptions& options);

// Appends the toolpath of a plan to one that exists, for example of another surface; a travel connects them.
void add_spans(const Surface& surface, const Plan& plan, const SpanOptions& options, std::vector<toolpath::Span>& out);

} // namespace filum::surfpath::plan
