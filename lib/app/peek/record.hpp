// A frame as named values, whatever it carries: what `peek` prints and sums up.
#pragma once

#include "stream/frame.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace filum::app::peek {

struct Record;

// Columns of equal length, by name.
using Table = std::vector<std::pair<std::string, std::vector<double>>>;
using Value = std::variant<double, std::int64_t, std::string, Table, std::vector<Record>>;

struct Record {
    std::string kind; // "layer", "loop", "curve"
    std::vector<std::pair<std::string, Value>> fields;
};

// What the frame says, in the order of its message.  An array that holds one value for all points becomes a number.
// Throws Error(bad_input) if the message breaks a promise of its kind.
Record record(const stream::RawFrame& frame);

} // namespace filum::app::peek
