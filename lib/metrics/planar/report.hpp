// Everything measured, as figures; and the tables with a line per layer or region.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "metrics/figures/figures.hpp"
#include "metrics/planar/air.hpp"
#include "metrics/planar/course.hpp"
#include "metrics/planar/layers.hpp"
#include "metrics/planar/pace.hpp"
#include "metrics/planar/pores.hpp"
#include "metrics/planar/turns.hpp"
#include "metrics/planar/widths.hpp"

#include <optional>

namespace filum::metrics::planar {

struct Options {
    std::string regions, per_region, per_layer; // files
    bool pores = false;                         // measure pores
    std::string format = "table";               // table | tsv | json
    std::string machine = "marlin", set;        // profile of the print time, and changes to it
    double pixel = 0;             // mm between the rows that areas are swept by; 0: a sixteenth of the bead width
    double filament_diameter = 0; // mm, from the profile; 0: the machine is not fed with filament
    double density = 1.24;        // g/cm3, but of fibre
    double fibre_density = 0;     // g/cm3, from the profile; 0: unknown
    std::int64_t turn_samples = 50000;
};

// What is known of the input besides its beads.
struct Input {
    bool whole_program = true; // a Toolpath; false for the curves of a fill, which have no course
    bool outlines = true;      // Regions were given
    Course course;
    double seconds = -1; // print time; below 0: unknown
    std::map<std::uint32_t, ToolShare> tools;
    Notes notes;                 // what the stages before dropped or repaired
    Facts facts;                 // and what they found out
    double claimed_unplaced = 0; // mm2, by the fill's own account
    std::optional<Air> air;      // where beads are known to lie on each other
    std::optional<Pores> pores;  // if asked for
};

// All figures, in the order in which they are to be read.
Figures report(const Input& input, const Beads& beads, const std::vector<polygon::Region>& regions,
               const std::vector<LayerFigures>& layers, const Options& options, int threads);

// TSV with a head line; that of layers is wider if pores were measured.
std::string region_table(const std::vector<LayerFigures>& layers);
std::string layer_table(const std::vector<LayerFigures>& layers, const std::optional<Pores>& pores);

} // namespace filum::metrics::planar
