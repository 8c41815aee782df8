// Counts, sums and bounds over the frames of a stream.
#pragma once

#include "app/peek/record.hpp"
#include "base/fact.hpp"
#include "base/note.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>

namespace filum::app::peek {

// Least and greatest of one quantity.
struct Range {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
    void add(double v) {
        lo = v < lo ? v : lo;
        hi = v > hi ? v : hi;
    }
    [[nodiscard]] bool empty() const { return lo > hi; }
};

struct Summary {
    std::map<std::string, std::uint64_t>
        records;                                // how many of each kind, nested ones included, notes and facts excluded
    std::map<std::string, std::uint64_t> named; // how many with each role, join and such: "role bead"
    std::map<std::string, double> areas;        // mm2, summed by name: "area", "unplaced"
    std::map<std::string, Range> ranges;        // mm, by name: x, y, z, width, height
    std::uint64_t points = 0;
    std::int64_t layers = 0, strokes = 0; // one more than the greatest index
    Facts facts;                          // as they come
    Notes notes;                          // summed by stage and kind, in the order of their first case
};

// Adds a frame, of which `record` is the content.
void add(Summary& summary, const stream::RawFrame& frame, const Record& record);

} // namespace filum::app::peek
