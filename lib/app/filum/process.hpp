// Child processes joined by pipes.
#pragma once

#include <string>
#include <vector>

namespace filum::app::filum {

using Command = std::vector<std::string>; // program file and arguments

// What the command writes to standard output.  Throws Error(failure) if it does not end with 0.
std::string output_of(const Command& command);

// Replaces this process.  Throws Error(failure) if that is not possible.
[[noreturn]] void become(const Command& command);

// How one child ended: the exit code, or 128 + the signal that killed it.
struct Ended {
    int code = 0;
    bool by_signal = false;
};

// Runs the commands at once, each one's standard output piped to the next one's standard input; the first reads ours,
// the last writes ours.  The children die with this process, however it dies.  All but the first are told by the
// environment variable FILUM_CHAIN that they read from a stage whose own failure is reported.
// Returns how each ended.  Throws Error(failure) if a process or a pipe cannot be made.
std::vector<Ended> run_piped(const std::vector<Command>& commands);

// The exit code of a whole chain: that of the first stage that failed by itself, rather than because its neighbour
// did (the writer before it stopped: code 4; the reader behind it left: SIGPIPE).  `who` becomes its place.
int verdict(const std::vector<Ended>& ended, std::size_t& who);

} // namespace filum::app::filum
