// In which order rows are laid, so that turns between them are good ones.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::plan {

// Ends of rows: 2 r is the begin of row r, 2 r + 1 its end.
struct Link {
    std::uint32_t from = 0, to = 0; // ends, from < to, of two rows
    double cost = 0;
};

// The rows in an order in which few that were taken have links to others that were not: from the one with the fewest
// links on, always the one among those linked to what is taken after which these are least; then what is not linked to
// them.  Ties: the least number.
std::vector<std::uint32_t> sweep(std::uint32_t rows, std::span<const Link> links);

// A row as it is passed.
struct Visit {
    std::uint32_t row = 0;
    bool reversed = false;
};

// The end by which a row is entered; it is left by the other one.
inline std::uint32_t entry(const Visit& v) { return 2 * v.row + (v.reversed ? 1 : 0); }
inline std::uint32_t leave(const Visit& v) { return entry(v) ^ 1U; }

struct Costs {
    double breaks = 0; // for every chain
    double gap = 0;    // where, on one of both sides, no link leads from the rows up to here to those beyond
};

// The chains that links make: `link` is per end the one that it has, kNone if none.  They close no ring.
std::vector<std::vector<Visit>> chains(std::span<const Link> links, std::span<const std::uint32_t> link);

// Chains that pass every row once, joined by links; the sum of all costs is small.  Rows are taken one after the other;
// of the ways to join the ends that lie open behind them, the cheapest `kept` go on (a beam through the frontier states
// of a Hamiltonian path problem: exact where they never are more). Fast where links join rows whose numbers are near to
// each other.  Ties: the first link.
std::vector<std::vector<Visit>> order(std::uint32_t rows, std::span<const Link> links, const Costs& costs,
                                      std::size_t kept);

} // namespace filum::surfpath::plan
