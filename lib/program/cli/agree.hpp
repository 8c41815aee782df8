// Settings of the runs that made a stream, and those that differ between stages: see Option::same_as.
#pragma once

#include "cli/command.hpp"

#include <string_view>

namespace filum::cli {

// The setting of that name; null if the run has none.
const stream::Setting* setting(const stream::Run& run, std::string_view name);

// One note for each setting in io.same whose value differs from that of an earlier stage. This run is the last one in
// header.history; if a program ran several times, its latest run counts. A setting that only one of the two runs has
// differs if it is not at its default.
Notes disagreements(const Io& io, const stream::Header& header);

} // namespace filum::cli
