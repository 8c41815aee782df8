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

// The range of one quantity.
struct Range {
    double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
    void add(double v) {
        lo = v < lo ? v : lo;
        hi = v > hi ? v : hi;
    }
    [[nodiscard]] bool empty() const { return lo > hi; }
};

struct Summary {
    std::map<std::string, std::uint64_t> records; // count of each kind; with nested records, without notes and facts
    std::map<std::string, std::uint64_t> named;   // count of each word value, such as "role bead"
    std::map<std::string, double> areas;          // mm2, summed by name: "area", "unplaced"
    std::map<std::string, Range> ranges;          // mm, by name: x, y, z, width, height
    std::uint64_t points = 0;
    std::int64_t layers = 0, strokes = 0; // one more than the greatest index
    Facts facts;                          // in the order of the stream
    Notes notes;                          // summed by stage and kind, in the order of their first case
};

// Adds a frame to the summary.  `record`: the content of the frame.
void add(Summary& summary, const stream::RawFrame& frame, const Record& record);

} // namespace filum::app::peek
