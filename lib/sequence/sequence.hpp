// The processing order over all layers (docs/algorithms/sequence.md; Sun et al. 2019, 3.1): few strokes that the head
// can print, and a proven bound.
#pragma once

#include "base/fact.hpp"
#include "machine/head.hpp"
#include "sequence/ends.hpp"

#include <functional>

namespace filum::sequence {

struct Options {
    bool by_layers = false; // strictly layer by layer
    // if so: an order to take as it is, for comparison; none: the one with the fewest strokes
    std::function<Order(std::span<const polygon::Region>)> layers = {};
    machine::Head head;
    std::uint64_t budget = 600'000'000; // steps that searches and bounds may take
};

struct Result {
    Order order;                       // ids in the order of printing
    std::vector<std::uint32_t> stroke; // by place in `order`
    std::vector<Join> join;            // likewise
    std::vector<End> ends;             // of the strokes
    Graph graph;                       // that was ordered
    // regions, columns, collisions;
    // layer-floor (regions - layers + 1: layer by layer has no fewer strokes);
    // path-cover, relaxation-bound, lower-bound: no order that the head allows has fewer strokes than any
    // of these (path-cover: nor without a head); lower-bound is the best of them, or the strokes if the search proved
    // its order best;
    // planned-strokes; gap (% of the strokes that lower-bound leaves open);
    // ends-...: strokes by the cause of their end, see ends.hpp;
    // steps (millions) taken by search and bounds; search-complete (1 if the search left nothing out, so that nothing
    // has fewer strokes)
    Facts facts;
    std::string bound_by; // what proved lower-bound: path-cover, relaxation-bound or search
};

// Orders `regions`, which come layer by layer with ids from 0 without gaps; their outlines are given up.
// Every order passes check(); layer order is always one of those compared, so it never does worse.
// The same result for the same regions and options, on any machine: the budget counts steps, not time.
// Throws Error(bad_input) if the regions are not what `regions` writes.
Result sequence(std::vector<polygon::Region> regions, const Options& options);

} // namespace filum::sequence
