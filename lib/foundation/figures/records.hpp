// Facts and notes of earlier stages, as figures.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "figures/figures.hpp"

namespace filum::figures {

// Appends every fact, and the notes summed by stage and phrase, in the order in which they first come.
void add_records(const Notes& notes, const Facts& facts, Figures& out);

} // namespace filum::figures
