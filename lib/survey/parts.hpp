// The two jobs, and what they share; private to lib/survey.
#pragma once

#include "survey/survey.hpp"

namespace filum::survey {

figures::Figures planar(const metrics::Options& options, const cli::Io& io);

figures::Figures curved(const Options& options, const cli::Io& io);

} // namespace filum::survey
