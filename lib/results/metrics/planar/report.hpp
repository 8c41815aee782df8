// All measurements as figures, and tables by layer and by region.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "figures/figures.hpp"
#include "metrics/planar/air.hpp"
#include "metrics/planar/layers.hpp"
#include "metrics/planar/pace.hpp"
#include "metrics/planar/path_statistics.hpp"
#include "metrics/planar/pores.hpp"
#include "metrics/planar/turns.hpp"
#include "metrics/planar/widths.hpp"

#include <optional>

namespace filum::metrics::planar {

struct Options {
    std::string regions, per_region, per_layer, per_pore; // files
    bool pores = false;                                   // measure pores
    std::string format = "table";                         // table | tsv | json
    std::string machine = "marlin", set;                  // profile for the print time, and changes to it
    double pixel = 0; // mm between the rows along which areas are integrated; 0: a sixteenth of the bead width
    double filament_diameter = 0; // mm, from the profile; 0: the machine uses no filament
    double density = 1.24;        // g/cm3, except for fibre
    double fibre_density = 0;     // g/cm3, from the profile; 0: unknown
    std::int64_t turn_samples = 50000;
};

// Properties of the input in addition to its beads.
struct Input {
    bool whole_program = true; // a Toolpath; false for the curves of fill, which are not in printing order
    bool outlines = true;      // whether Regions were given
    PathStatistics statistics;
    double seconds = -1; // print time; negative: unknown
    std::map<std::uint32_t, ToolShare> tools;
    Notes notes;                 // of the earlier stages
    Facts facts;                 // of the earlier stages
    double claimed_unplaced = 0; // mm2, as fill reports
    std::optional<Air> air;      // if the layers of beads are known
    std::optional<Pores> pores;  // if requested
};

// All figures, in order of importance.
Figures report(const Input& input, const Beads& beads, const std::vector<polygon::Region>& regions,
               const std::vector<LayerFigures>& layers, const Options& options, int threads);

// TSV with a header; that of layers has more columns if pores were measured.
std::string region_table(const std::vector<LayerFigures>& layers);
std::string layer_table(const std::vector<LayerFigures>& layers, const std::optional<Pores>& pores);

} // namespace filum::metrics::planar
