// `sequence`: orders the regions of all layers (docs/algorithms/sequence.md; Sun et al. 2019, 3.1) for few strokes
// that the head can print, with a proven bound.
#pragma once

#include "base/fact.hpp"
#include "machine/heads.hpp"
#include "sequence/ends.hpp"

#include <functional>

namespace filum::sequence {

struct Options {
    bool by_layers = false; // strictly layer by layer
    // With by_layers: computes the order, for comparison; empty: the one with the fewest strokes.
    std::function<Order(std::span<const polygon::Region>)> layers = {};
    machine::Heads heads;               // of the tools
    Priority first = Priority::strokes; // what is reduced first in jobs with several tools
    std::uint64_t budget = 600'000'000; // steps for searches and bounds
    bool from_inside = false;           // of nested strokes the inner ones come first, where they can
};

struct SequenceResult {
    Order order;                       // ids in the order of printing
    std::vector<std::uint32_t> stroke; // per place in `order`
    std::vector<Join> join;            // per place in `order`
    std::vector<End> ends;             // of the strokes
    Graph graph;                       // the graph of the job
    // Facts: regions, columns, collisions; collisions-assumed (of them, those that were too costly to measure, if there
    // are any); layer-floor (regions - layers + 1: no order by layers has fewer strokes);
    // path-cover, relaxation-bound, lower-bound: no order that the head allows has fewer strokes than any of these
    // (for path-cover not even without a head); lower-bound is the best of them, or the strokes if the search proved
    // its order optimal; planned-strokes; gap (% of the strokes between lower-bound and planned-strokes); ends-...:
    // strokes by the cause of their end (ends.hpp); steps (millions) of search and bounds; search-complete (1 if the
    // search was exhaustive, so no order has fewer strokes).
    // With from_inside: outer-first, the strokes that come before one that they surround. With several tools also:
    // tools; tool-changes; tool-changes-bound: no order changes the tool less often.
    Facts facts;
    std::string bound_by; // method that proved lower-bound: path-cover, relaxation-bound or search
};

// Orders `regions`, which must come layer by layer with consecutive ids from 0; their outlines are moved. Every order
// passes check(); layer order is always among those compared. The result depends on regions and options only, as the
// budget counts steps rather than time.
// Throws Error(bad_input) if the regions are not as `regions` writes them.
SequenceResult sequence(std::vector<polygon::Region> regions, const Options& options);

} // namespace filum::sequence
