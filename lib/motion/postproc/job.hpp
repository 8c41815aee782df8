// The figures of a job: strokes, lengths, material and time, tool by tool and in all.
#pragma once

#include "base/note.hpp"
#include "figures/figures.hpp"
#include "postproc/first_pass.hpp"

#include <string>
#include <vector>

namespace filum::postproc {

// A group of figures per tool, "tool 0", "tool 1 (fibre)", and one of the whole "job".  It holds strokes, cuts, length
// laid, fibre used (laid, and pushed into the air), travel, and material as it leaves the nozzle.  Mass is there if the
// profile has the density.  Printing and travel have their times, each with its pauses; codes of templates count 0 s.
figures::Figures job(const machine::Profile& profile, const FirstPass& first_pass);

// The price of the material of the whole job, in the user's money; 0 if the price of a material is not known.
double cost(const machine::Profile& profile, const FirstPass& first_pass);

// The same figures as comment lines.  Empty if the totals tell everything: one tool, and no fibre.
std::vector<std::string> job_lines(const machine::Profile& profile, const FirstPass& first_pass);

// A note on the fibre strokes that are left out; empty if there are none.
Notes omissions(const FirstPass& first_pass);

} // namespace filum::postproc
