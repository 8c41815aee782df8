// The whole job of `peek`: a stream in, what is in it as text out.
#pragma once

#include "cli/command.hpp"

#include <cstdint>

namespace filum::app::peek {

struct Options {
    bool check = false, text = false, json = false, script = false, frames = false; // at most one: what to print
    bool defaults = false;                                                          // of the script: all options
    std::int64_t decimals = 6;                                                      // of the text
};

// Reads the whole stream, and so verifies it.  Of one that is cut or corrupt, what comes before the fault is printed
// before the Error goes on.  Throws Error(usage) for options that do not go together.
void run(const Options& options, const cli::Io& io);

} // namespace filum::app::peek
