// The pores of a scaffold, measured on what was laid.
//
//   strand     a straight stretch of beads at least three median bead widths long, within one degree of the layer's
//              main direction (that of most bead length); one that a hole interrupts counts for each piece, and so do
//              the sides of rings in that direction
//   spacing    median distance between neighbouring strand lines of a layer, of those that lie more than 1.1 bead
//   widths
//              apart
//   opening    a connected part of a plan view that lies in the outlines, free of beads (connectors are left out) and
//              enclosed by beads all round, with its largest inscribed circle; those with a circle smaller than an
//              eighth of a bead across are chinks and left out
//   pore size  the diameter of that circle, of every opening in the plan view of a layer together with those above it
//   up
//              to the first of another direction (at the top: below it): of a 0/90 stack the window between two strands
//              and the two that cross them
//   vertical throat  the same in the plan view of all layers: the largest ball that falls straight through
//   lateral throat   of a layer: the largest ball that rolls along the channel between two neighbouring strands, which
//              the layers that cross it above and below bound: the smaller of spacing - width and the height of the
//              consecutive layers of the same direction (within one degree)
//   porosity by volume   1 - (sum of length * width * height of the beads) / (sum of outline area * height): that is
//   the
//              extruded volume, whatever shape the strand's section takes
//   porosity by area     1 - (area under beads) / area, of all layers: what lies twice on one place counts once
//   lattice porosity     1 - width / spacing, by the medians of width and spacing: of strands without turns and rings
//   in
//              an endless part, each width * height in section; the analytic value
//
// All in mm.  Circles are found to 0.002 mm.  (scaffold terms: pore size and throat as in mercury and sphere models)
#pragma once

#include "metrics/figures/figures.hpp"
#include "metrics/planar/beads.hpp"
#include "metrics/planar/layers.hpp"

namespace filum::metrics::planar {

using metrics::figures::Figures;

struct LayerPores {
    std::uint32_t layer = 0;
    double height = 0;           // mm
    std::size_t strands = 0;     //
    double direction = 0;        // rad, [0, pi), of the strands
    double width = 0;            // mm, median of the strands
    double spacing = 0;          // mm; 0 if there are not two lines
    double lateral = 0;          // throat, mm; 0 if there is no channel
    std::vector<double> circles; // diameters, mm, ascending: one per opening seen from this layer
};

struct Pores {
    double part = 0, material = 0; // mm3
    double area = 0, covered = 0;  // mm2, of all layers
    std::vector<LayerPores> layers;
    std::vector<double> through; // diameters, ascending: openings through all layers
};

// `layers` as measure_layers gives them, of the same beads and regions.  Same result for any `threads`.
Pores measure_pores(const Beads& beads, const std::vector<polygon::Region>& regions,
                    const std::vector<LayerFigures>& layers, int threads);

void pore_figures(const Pores& pores, Figures& out);

// A layer's strands, spacing, throat and pores as cells of TSV, and the heads of these columns.
std::string pore_columns();
std::string pore_cells(const Pores& pores, std::uint32_t layer);

// The strands of one layer: fills strands, direction, width, spacing.
LayerPores find_strands(const LayerBeads& beads);

// The diameter of the largest circle in a simple connected area, mm, to 0.002.
double inscribed_circle(const polygon::Loops& area);

} // namespace filum::metrics::planar
