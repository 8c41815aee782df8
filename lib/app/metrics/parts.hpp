// The two jobs, and what they share; private to lib/app/metrics.
#pragma once

#include "app/metrics/metrics.hpp"

namespace filum::app::metrics {

filum::metrics::figures::Figures planar(const filum::metrics::planar::Options& options, const cli::Io& io);

filum::metrics::figures::Figures curved(const Options& options, const cli::Io& io);

// Maps the path on the surface, writes that to `options.map`, and gives its figures.  What plies are to follow: angles
// that `laminate` said, else the field "direction", else the pull of the first load case; the surface's fields
// "ply-K.edge", from 1, as the map of `laminate` has them, tell where they are to lie.
filum::metrics::figures::Figures mapped(const Options& options, const cli::Io& io, const surface::Sheet& sheet,
                                        const cli::Whole& ground, const filum::metrics::surface::Fibres& fibres,
                                        const cli::Whole& path);

} // namespace filum::app::metrics
