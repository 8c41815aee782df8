// The whole job of `laminate`: plies at angles to a reference direction, one on the other.
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
    Vec3 reference{1, 0, 0}; // of the angles, laid onto the surface
    surfpath::Keep keep = surfpath::Keep::usual;
    double least_radius = 2.4; // mm: of turns, where there is room
    bool stagger = true;       // plies of one direction lie beside each other by shares of a spacing, births, too
    bool strict = false;       // no turn may be tighter than least_radius
    double lift = 5;           // mm: how high the tool travels
    double turn_outside = 0;   // mm: how far beyond the rims rows may turn; 0: not
    double ramp = 0;           // mm of way per mm of height, at least, where plies end; 0: they end as asked
    std::map<std::string, Within> areas{}; // what the plies' words say
    std::function<void()> done{};          // called for each ply when it is laid; from any thread, one at a time
};

// A ply as it was laid.
struct Laid {
    Surface ground;                      // what it lies on: the base's triangles, raised; turned over of a ply under it
    Surface sheet;                       // what of that it covers, or all with a flange about it, to turn on
    std::uint32_t part = surface::kNone; // triangles of the sheet, the first ones, that are no flange
    surfpath::Plan plan;                 // on the sheet
    double turn = 0;          // rad, of its fibres from the reference, as seen from the side that the ground faces
    std::vector<double> edge; // mm per vertex of the ground, below 0 where the ply is to lie; empty: everywhere
};

struct Laminate {
    std::vector<Laid> plies; // in the order of laying, as given
    metrics::surface::Map map;
    Notes notes;
    Facts facts;
};

// Every ply by `field` on the surface raised by the heights of those laid before it on its side
// (surface/curve/raise.hpp). Facts, as metrics/surface/map_figures.hpp has them: "plies", "unsymmetric" and
// "unbalanced" (plies), "thickness-nominal", "-mean", "-least", "-low", "-high",
// "-most" (mm, at points), "even-least", "even-most" (mm, means about a bead's width), and of every ply "ply.K.cuts",
// "ply.K.length", "ply.K.bare", "ply.K.twice", "ply.K.thrice" (shares of the area, what is laid
// thrice is laid twice, too), "ply.K.gap" (mm: ninety-nine
// hundredths of the area are at most that far from a bead), "ply.K.angle-median" and "-mean" (degrees) and "-within"
// (share of the length within 15 degrees), "ply.K.asked" (degrees from the reference, as seen from the ply's side);
// "reference-x", "-y" and "-z"; with turns outside "ply.K.trims" and "ply.K.outside" (mm beyond the rims); of plies
// that do not lie everywhere "ply.K.area" (mm2). Notes: those of the plans, with their ply; stacks that are not
// symmetric; grounds that fold or have no room; edges that are moved for the ramp, or cannot be (edges.hpp); plies that
// do not turn outside, since they end within the part. Throws Error as surfpath::plan does, with the ply.
Laminate laminate(const surface::Sheet& sheet, std::span<const Ply> plies, const Options& options, int threads);

// Its toolpath: a layer per ply, from `layer` and `stroke` on, behind what `out` holds.
void add_spans(const Laminate& laminate, std::span<const Ply> plies, const Options& options, std::uint32_t layer,
               std::vector<toolpath::Span>& out);

} // namespace filum::laminate
