// The two jobs, and what they share; private to lib/survey.
#pragma once

#include "survey/survey.hpp"

namespace filum::survey {

metrics::figures::Figures planar(const metrics::planar::Options& options, const cli::Io& io);

metrics::figures::Figures curved(const Options& options, const cli::Io& io);

} // namespace filum::survey
