// Headers, frames and sums as text and as JSON.
#pragma once

#include "app/peek/record.hpp"
#include "app/peek/summary.hpp"

#include <string>

namespace filum::app::peek {

// The payload, then a line per run of the history: its number, program, version, parents and settings.
std::string text(const stream::Header& header);

// The record's values on one line, nested records below it, a line per point; coordinates with `decimals` digits.
std::string text(const Record& record, int decimals);

std::string text(const Summary& summary);

// JSON objects, in one line each; numbers read back as the same value, nan is null.
std::string json(const stream::Header& header);
std::string json(const Record& record);
std::string json(const Summary& summary);

// A bash script that makes the stream again from its input, "$1": the pipeline that the history tells.  Options that
// have their default are left out unless `defaults`.
std::string script(const stream::Header& header, bool defaults);

} // namespace filum::app::peek
