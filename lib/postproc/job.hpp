// What a job takes, tool by tool and in all.
#pragma once

#include "base/note.hpp"
#include "metrics/figures/figures.hpp"
#include "postproc/first_pass.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

// A group of figures per tool, "tool 0", "tool 1 (fibre)", and one of the whole "job": strokes, cuts, length laid,
// fibre used (laid, and pushed into the air), travel, material as it leaves the nozzle, mass where the profile has the
// density, time of printing and of travel, each with its pauses.  The codes of templates take no time.
metrics::figures::Figures job(const machine::Profile& profile, const FirstPass& first_pass);

// The same as comment lines, if there is more to tell than the totals say: several tools, or fibre.
std::vector<std::string> job_lines(const machine::Profile& profile, const FirstPass& first_pass);

// A note of `stage` on fibre strokes that are left out, if any are.
Notes omissions(const FirstPass& first_pass);

} // namespace filum::postproc
