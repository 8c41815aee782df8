// The whole job of `peek`: reads a stream and prints its content as text.
#pragma once

#include "cli/command.hpp"

#include <cstdint>

namespace filum::app::peek {

struct Options {
    bool check = false, text = false, json = false, script = false, frames = false; // what to print: at most one
    bool defaults = false;                                                          // the script has all options
    std::int64_t decimals = 6;                                                      // digits of coordinates in the text
};

// Reads and so verifies the whole stream.  If the stream is truncated or corrupt, the content before the fault is
// printed before the Error is thrown.  Throws Error(usage) for options that do not go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::peek
