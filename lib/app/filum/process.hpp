// Child processes joined by pipes.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace filum::app::filum {

using Command = std::vector<std::string>; // program, looked for on the PATH unless it has a '/', and arguments

// What the command writes to standard output, reading nothing.  `silently`: what it says on standard error, of one
// argument, is dropped.  Throws Error(failure) if it does not end with 0.
std::string output_of(const Command& command, bool silently = false);

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
// `speakers`: who says the notes of the stages on standard error; they are told by the environment variable
// FILUM_NOTES. What a command writes goes to the file of `copies` as well, where one is named: complete only if all
// ended well. `look` is called again and again with who has ended, until all have; it should wait a little. Returns how
// each ended.  Throws Error(failure) if a process or a pipe cannot be made or a copy was not written.
enum class Speakers { each, last };
using Look = std::function<void(const std::vector<bool>& ended)>;
std::vector<Ended> run_piped(const std::vector<Command>& commands, const std::vector<std::string>& copies = {},
                             const Look& look = {}, Speakers speakers = Speakers::each);

// The exit code of a whole chain: that of the first stage that failed by itself, rather than because its neighbour
// did (the writer before it stopped: code 4; the reader behind it left: SIGPIPE).  `who` becomes its place.
int verdict(const std::vector<Ended>& ended, std::size_t& who);

} // namespace filum::app::filum
