// The pores of a scaffold, measured on its toolpath. All in mm; circles are exact to 0.002 mm; pore size and throat as
// in mercury porosimetry and sphere models.
// - strand: a straight run of beads at least three median bead widths long, within one degree of the layer's main
//   direction (the one with the greatest bead length). A strand that a hole interrupts counts once per part; sides of
//   rings in that direction count, too.
// - spacing: median distance between adjacent strand lines of a layer, among those that are more than 1.1 bead widths
//   apart.
// - opening: a connected part of a plan view inside the outlines that is free of beads (except connectors) and enclosed
//   by beads, with its largest inscribed circle. Openings with a circle smaller than an eighth of a bead width do not
//   count.
// - pore size: the diameter of that circle, of every opening in the plan view of a layer together with those above it
//   up to the first of another direction (at the top: below it): in a 0/90 stack the window between two strands and the
//   two that cross them.
// - vertical throat: the same in the plan view of all layers: the largest ball that can fall straight through.
// - lateral throat of a layer: the largest ball that can roll along the channel between two adjacent strands, which the
//   crossing layers above and below bound: the smaller one of spacing - width and the height of the consecutive layers
//   of the same direction (within one degree).
// - porosity by volume: 1 - (sum of length * width * height of the beads) / (sum of outline area * height): the
//   extruded volume, independent of the shape of the strand's section.
// - porosity by area: 1 - (area under beads) / area, of all layers: overlapping beads count once.
// - lattice porosity: 1 - width / spacing, by the medians of width and spacing: the analytic value of endless strands
//   without turns and rings, each with a section of width * height.
#pragma once

#include "figures/figures.hpp"
#include "metrics/planar/beads.hpp"
#include "metrics/planar/layers.hpp"

namespace filum::metrics::planar {

using figures::Figures;

// An opening that is visible from a layer.
struct Opening {
    double diameter = 0; // mm, of the largest circle in it
    Vec2 at;             // the centroid of its area
};

struct LayerPores {
    std::uint32_t layer = 0;
    double height = 0;             // mm
    std::size_t strands = 0;       //
    double direction = 0;          // rad, [0, pi), of the strands
    double width = 0;              // mm, median of the strands
    double spacing = 0;            // mm; 0 with fewer than two lines
    double lateral = 0;            // throat, mm; 0 without a channel
    std::vector<Opening> openings; // by ascending diameter: those visible from this layer
};

struct Pores {
    double part = 0, material = 0; // mm3
    double area = 0, covered = 0;  // mm2, of all layers
    std::vector<LayerPores> layers;
    std::vector<double> through; // diameters, ascending: openings through all layers
};

// Precondition: `layers` is the result of measure_layers() for the same beads and regions. The result does not depend
// on `threads`.
Pores measure_pores(const Beads& beads, const std::vector<polygon::Region>& regions,
                    const std::vector<LayerFigures>& layers, int threads);

void pore_figures(const Pores& pores, Figures& out);

// Strands, spacing, throat and pores of a layer as cells of TSV, and the column names.
std::string pore_columns();
std::string pore_cells(const Pores& pores, std::uint32_t layer);

// A line for each opening of each layer, as TSV: layer, place, diameter.
std::string pore_table(const Pores& pores);

// Measures the strands of one layer: sets strands, direction, width, spacing.
LayerPores find_strands(const LayerBeads& beads);

// The diameter of the largest circle in a simple connected area, mm, exact to 0.002.
double inscribed_circle(const polygon::Loops& area);

} // namespace filum::metrics::planar
