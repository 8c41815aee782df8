// The two jobs of `metrics`: toolpaths in layers and paths on a surface.  Private to lib/program/app/metrics.
#pragma once

#include "app/metrics/metrics.hpp"

namespace filum::app::metrics {

// The figures of a toolpath in layers.
filum::figures::Figures planar(const filum::metrics::planar::Options& options, const cli::Io& io);

// The figures of a path on the surface options.surface.
filum::figures::Figures curved(const Options& options, const cli::Io& io);

// Maps the path on the surface, writes the map to the file options.map, and returns its figures.  The requested
// direction of a ply is the angle in the facts of `laminate`; else the field "direction"; else the first principal
// direction of the first load case.  The fields "ply-K.edge" of the surface, K from 1, give the areas of the plies, as
// in the map of `laminate`.  Throws Error(failure) if there is no path.
filum::figures::Figures mapped(const Options& options, const cli::Io& io, const surface::Sheet& sheet,
                               const cli::WholeInput& ground, const filum::metrics::surface::Fibres& fibres,
                               const cli::WholeInput& path);

} // namespace filum::app::metrics
