// Improves an order of rows by exchanging links.
#pragma once

#include "surfpath/plan/order.hpp"

namespace filum::surfpath::plan {

// The same rows in chains of lower cost, found by exchanging links (Lin and Kernighan 1973): a link that costs `dear`
// or more, or an open end, starts a search that adds links and removes others, at most a handful at once, until the
// chains are complete again. Ends when no exchange helps or after about a tenth of a second of work. `costs` are those
// of order(), `links` the links of the given chains. Ties: the first link.
std::vector<std::vector<Visit>> improved(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                         double dear, std::vector<std::vector<Visit>> given);

} // namespace filum::surfpath::plan
