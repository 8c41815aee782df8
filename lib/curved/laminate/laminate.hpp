// `laminate`: plans plies at angles to a reference direction, one on top of the other.
#pragma once

#include "laminate/stack.hpp"
#include "metrics/surface/map.hpp"
#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

#include <functional>
#include <map>

namespace filum::laminate {

using geom::Vec3;
using surface::Surface;

struct Options {
    Vec3 reference{1, 0, 0}; // direction from which angles are measured, projected onto the surface
    surfpath::Priority keep = surfpath::Priority::usual;
    surfpath::RowTurns turns = surfpath::RowTurns::usual; // usual: the cheaper
    long rim_beads = 0;        // most closed beads along rims; they keep the turns of plies apart (rims.hpp)
    double width_change = 0;   // share by which beads may be wider or narrower than the spacing
    double least_radius = 2.4; // mm: of turns, where there is room
    bool stagger = true;     // plies of one direction are displaced by shares of a spacing, and their births move apart
    bool strict = false;     // fail if more than max_tight of a ply turns tighter than least_radius
    double max_tight = 0.01; // share of its length
    double min_length = 0;   // mm: shorter pieces of fibre are left out
    double lift = 5;         // mm above the surface for travels
    double turn_outside = 0; // mm outside the rims in which rows may turn; 0: none
    double ramp = 0;         // mm of way per mm of height, at least, where plies end; 0: they end as given
    std::map<std::string, Area> areas{}; // areas by the words of the plies
    std::function<void()> done{};        // called when a ply is planned; from any thread, one at a time
};

// A ply with its ground and its plan.
struct PlacedPly {
    Surface ground;                      // the surface below it: the base raised, and reversed for a ply on the back
    Surface sheet;                       // the part of the ground that it covers, or all with a flange to turn on
    std::uint32_t part = surface::kNone; // number of triangles of the sheet that are not flange; they come first
    surfpath::Plan plan;                 // on the sheet
    double turn = 0;          // rad from the reference to its fibres, as seen from the side that the ground faces
    std::vector<double> edge; // mm per vertex of the ground, negative inside the ply; empty: it covers everything
};

struct Laminate {
    std::vector<PlacedPly> plies; // in the order given
    metrics::surface::Map map;
    Notes notes;
    Facts facts;
};

// Plans every ply by `field` on the surface raised by the plies below on its side (surface/curve/raise.hpp).
// Facts (metrics/surface/map_figures.hpp): "plies", "unsymmetric" and "unbalanced" (plies); "thickness-nominal",
// "-mean", "-least", "-low", "-high", "-most" (mm, at points), "even-least", "even-most" (mm, means around a bead's
// width); for every ply "ply.K.cuts", "ply.K.length", "ply.K.bare", "ply.K.twice", "ply.K.thrice" (shares of the area
// under no bead, at least two and at least three passes), "ply.K.gap" (mm: 99th percentile by area of the distance
// from a bead), "ply.K.angle-median", "-mean" (degrees) and "-within" (share of the length within 15 degrees),
// "ply.K.asked" (degrees from the reference, seen from the ply's side); "reference-x", "-y" and "-z"; "ply.K.upright"
// (mm2 where the reference direction is too close to the normal to count); with turns outside "ply.K.trims" and
// "ply.K.outside" (mm outside the rims); for plies with an edge "ply.K.area" (mm2). Notes: those of the plans, with
// their ply; stacks that are not symmetric; grounds that fold or have no room; edges that were moved for the ramp, or
// cannot be (edges.hpp); plies that do not turn outside because they end inside the part. Throws Error as
// surfpath::plan_paths does, naming the ply.
Laminate laminate(const surface::Sheet& sheet, std::span<const Ply> plies, const Options& options, int threads);

// Appends its toolpath, a layer per ply, to `out`; numbers start at `layer` and `stroke`.
void add_spans(const Laminate& laminate, std::span<const Ply> plies, const Options& options, std::uint32_t layer,
               std::vector<toolpath::Span>& out);

} // namespace filum::laminate
