// Converts any frame to named values: every field of its message, read by the reflection of protobuf.
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
using Table = std::vector<Column>; // columns of equal length

struct Word {
    std::string text;
    bool named = false; // one of a fixed set of values: a role, a join
};

struct Entry {
    std::string name, unit; // "mm", "mm2"; empty for pure numbers and for values that are no number
    std::variant<double, std::int64_t, Word, Table, std::vector<Record>> value;
};

// A message as entries: numbers and words first, then tables, then records within it. Each group is in the order of the
// message.
struct Record {
    std::string kind; // "layer", "loop", "curve"
    std::vector<Entry> entries;
};

// All fields of the frame. Arrays become columns of tables; those with one entry per point form the table "points". One
// value for all points becomes a number. A message with offsets `start` becomes one record per part: Loops become
// "loop" records. A missing message is an empty list. Throws Error(bad_input) if the message violates the rules of its
// kind.
Record record(const stream::RawFrame& frame);

} // namespace filum::wire
