// Orders rows such that the turns between them are good ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::plan {

// Row r begins at end 2 r and ends at end 2 r + 1.
struct Link {
    std::uint32_t from = 0, to = 0; // ends of two rows, from < to
    double cost = 0;
};

// A numbering of the rows with a small frontier (rows already taken that have links to rows not taken): starts with
// the row of fewest links; next is the row, among those linked to a taken one, after which the frontier is smallest.
// Rows without such links start anew. Ties: the smallest number.
std::vector<std::uint32_t> sweep(std::uint32_t rows, std::span<const Link> links);

// One passage along a row.
struct Visit {
    std::uint32_t row = 0;
    bool reversed = false;
};

// The end at which a row is entered; it is left at the other one.
inline std::uint32_t entry(const Visit& v) { return 2 * v.row + (v.reversed ? 1 : 0); }
inline std::uint32_t leave(const Visit& v) { return entry(v) ^ 1U; }

struct Costs {
    double breaks = 0; // for every chain
    double gap = 0; // for every row after which, on one of the two sides, no link leads from earlier rows to later ones
};

// The chains that links form. `link`: per end its link, kNone if none. No chain may be closed.
std::vector<std::vector<Visit>> chains(std::span<const Link> links, std::span<const std::uint32_t> link);

// Chains that together pass every row once, such that the sum of costs is small. A beam search over the rows in their
// order: a state is the set of open ends (the frontier of a Hamiltonian path problem), and the `kept` cheapest states
// survive; the result is optimal if there are never more. Fast if links connect rows with near numbers. Ties: the
// first link.
std::vector<std::vector<Visit>> order(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                      std::size_t kept);

} // namespace filum::surfpath::plan
