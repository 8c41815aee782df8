// The whole job of `laminate`: plies at angles to a reference direction, one on the other.
#pragma once

#include "laminate/stack.hpp"
#include "laminate/thickness.hpp"
#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::laminate {

struct Options {
    Vec3 reference{1, 0, 0}; // of the angles, laid onto the surface
    surfpath::Keep keep = surfpath::Keep::usual;
    double least_radius = 2.4; // mm: of turns, where there is room
    bool stagger = true;       // plies of one direction lie beside each other by shares of a spacing
    bool strict = false;       // no turn may be tighter than least_radius
    double lift = 5;           // mm: how high the tool travels
};

struct Laminate {
    std::vector<Laid> plies; // in the order of laying, as given
    Map map;
    Notes notes;
    Facts facts;
};

// Every ply by `field` on the surface raised by the heights of those laid before it on its side (raise.hpp).
// Facts: "plies", "unsymmetric" and "unbalanced" (plies), "thickness-nominal", "-mean", "-least", "-low", "-high",
// "-most" (mm, at points), "even-least", "even-most" (mm, means about a bead's width), and of every ply "ply.K.cuts",
// "ply.K.length", "ply.K.bare", "ply.K.twice", "ply.K.thrice" (shares of the area, what is laid
// thrice is laid twice, too), "ply.K.gap" (mm: ninety-nine
// hundredths of the area are at most that far from a bead), "ply.K.angle-median" and "-mean" (degrees) and "-within"
// (share of the length within 15 degrees).
// Notes: those of the plans, with their ply; stacks that are not symmetric; grounds that fold or have no room.
// Throws Error as surfpath::plan does, with the ply.
Laminate laminate(const surface::Sheet& sheet, std::span<const Ply> plies, const Options& options, int threads);

// Its toolpath: a layer per ply, from `layer` and `stroke` on, behind what `out` holds.
void add_spans(const Laminate& laminate, std::span<const Ply> plies, const Options& options, std::uint32_t layer,
               std::vector<toolpath::Span>& out);

// The map as a surface with fields: "thickness", "thickness-even" (mm), "fibre-volume" (of what plies without gaps and
// overlaps hold), and of every ply "ply-K.passes", "ply-K.amount", "ply-K.deviation" (degrees).
surface::Sheet sheet_of(const Laminate& laminate, const std::string& name);

} // namespace filum::laminate
