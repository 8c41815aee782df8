// The processing order over all layers (paper 3.1, notes 3b): fewest strokes that the head can print.
#pragma once

#include "base/fact.hpp"
#include "machine/head.hpp"
#include "sequence/order.hpp"

#include <string>

namespace filum::sequence {

struct Options {
    std::string order = "columns"; // or "layers"
    machine::Head head;
    double support_area = 0.001; // mm2; a region waits for those below with which it shares this much
};

struct Result {
    Order order;                       // ids in the order of printing
    std::vector<std::uint32_t> stroke; // by place in `order`
    std::vector<Join> join;            // likewise
    Facts facts;
};

// Orders `regions`, which come layer by layer, ids without gaps.  The outlines are moved out of them.
Result sequence(std::vector<polygon::Region> regions, const Options& options);

} // namespace filum::sequence
