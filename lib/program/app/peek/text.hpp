// Formats headers, frames and summaries as text and as JSON.
#pragma once

#include "app/peek/record.hpp"
#include "app/peek/summary.hpp"

#include <string>

namespace filum::app::peek {

// The payload, then a line per run of the history: its number, program, version, parents and settings.
std::string text(const stream::Header& header);

// The record's values on one line, then a line for each nested record and each point.  Coordinates have `decimals`
// digits.
std::string text(const Record& record, int decimals);

std::string text(const Summary& summary);

// JSON objects, one line each.  Numbers read back as the same value; NaN becomes null.
std::string json(const stream::Header& header);
std::string json(const Record& record);
std::string json(const Summary& summary);

// A bash script that makes the stream again from its input "$1", by the pipeline in the history.  Options with their
// default values are left out unless `defaults`.
std::string script(const stream::Header& header, bool defaults);

} // namespace filum::app::peek
