// An order of rows made better by exchanging turns.
#pragma once

#include "surfpath/plan/order.hpp"

namespace filum::surfpath::plan {

// The same rows in chains that cost less, if exchanges of a few links lead there: one that costs `dear` or more is
// taken out, and from its ends links are put in and others taken out for them, a handful at most, until the chains hang
// together again (Lin and Kernighan 1973).  Goes on until no such link is left, none can be exchanged, or a tenth of a
// second's work is done.  Costs are those of order(), links those that the chains were made of.  Ties: the first link.
std::vector<std::vector<Visit>> improved(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                         double dear, std::vector<std::vector<Visit>> given);

} // namespace filum::surfpath::plan
