// A frame as named values, whatever it carries: every field of its message, read by protobuf's reflection.
#pragma once

#include "stream/frame.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace filum::wire {

struct Record;

struct Column {
    std::string name, unit;
    std::vector<double> values;
};
using Table = std::vector<Column>; // of equal length

struct Word {
    std::string text;
    bool named = false; // one of the values that the field can have: a role, a join
};

struct Entry {
    std::string name, unit; // "mm", "mm2"; empty for pure numbers and all that is no number
    std::variant<double, std::int64_t, Word, Table, std::vector<Record>> value;
};

// First numbers and words, then tables, then records within it, each in the order of the message.
struct Record {
    std::string kind; // "layer", "loop", "curve"
    std::vector<Entry> entries;
};

// All that the frame says.  Arrays stand together as the columns of a table, those with one entry per point as
// "points"; one value for all points is a number.  A message with offsets `start` becomes a record per part: Loops as
// "loop"s.  A message that is missing is an empty list.
// Throws Error(bad_input) if the message breaks a promise of its kind.
Record record(const stream::RawFrame& frame);

} // namespace filum::wire
