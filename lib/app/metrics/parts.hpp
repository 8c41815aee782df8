// The two jobs, and what they share; private to lib/app/metrics.
#pragma once

#include "app/metrics/metrics.hpp"

namespace filum::app::metrics {

filum::metrics::figures::Figures planar(const filum::metrics::planar::Options& options, const cli::Io& io);

filum::metrics::figures::Figures curved(const Options& options, const cli::Io& io);

} // namespace filum::app::metrics
