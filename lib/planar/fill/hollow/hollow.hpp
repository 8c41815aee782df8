// Fills regions that are partly sparse: walls, skins and sparse infill become one curve (docs/algorithms/infill.md).
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

namespace filum::fill::hollow {

struct Options {
    double bead_width = 0.4;      // mm, except in zones, which have their own
    bool overhang_shares = false; // measure the share of each wall's width that lies over air (Curve::over_air)
};

// Fills a region by its areas (Region::areas). The outer lanes of the region are its walls. The rest is cut along its
// zones into pieces, and a piece can have further walls along its own outline. What remains of a piece is divided into
// sparse and solid areas: solid areas get lanes, sparse areas the loops of lib/planar/infill, bridges straight rows.
// All of these are closed curves one bead apart, and exchanges join them into one.
//
// Returns closed curves, one if all could be joined, with a feature per segment; `unplaced` is the area in mm2 of the
// tiny rings that were left out. Notes: curves that could not be joined, and crossings that remain. Throws
// Error(bad_input) if an area has lines nearer than a bead, or too many of them.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

} // namespace filum::fill::hollow
