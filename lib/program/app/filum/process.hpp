// Runs child processes that are connected by pipes.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace filum::app::filum {

using Command = std::vector<std::string>; // the program, searched on the PATH unless it has a '/', then its arguments

// The standard output of the command, whose standard input is empty.  `silently`: its standard error is dropped, and
// only its first argument is used.  Throws Error(failure) if the command does not end with 0.
std::string output_of(const Command& command, bool silently = false);

// Replaces this process by the command.  Throws Error(failure) if that is not possible.
[[noreturn]] void become(const Command& command);

// How one child ended: the exit code, or 128 + the signal that killed it.
struct ProcessEnd {
    int code = 0;
    bool by_signal = false;
};

// Runs the commands at once.  The standard output of each is piped to the standard input of the next.  The first
// command reads the standard input of this process, and the last one writes its standard output.  The children end with
// this process, even if a signal kills it.  Returns how each command ended. The environment variable FILUM_CHAIN is set
// for all commands except the first: the command before reports its own failure.  `speakers`: whether each stage prints
// its own notes on standard error, or the last one those of all stages. The environment variable FILUM_NOTES passes
// this on. `copies`: a file for the output of each command, or ""; a copy is complete only if all commands ended with
// 0. `look`: called repeatedly until all commands have ended, with a flag for each: it has ended.  It should wait a
// little. Throws Error: failure if a process or a pipe cannot be made, io if a copy was not written.
enum class NotePrinters { each, last };
using Look = std::function<void(const std::vector<bool>& ended)>;
std::vector<ProcessEnd> run_piped(const std::vector<Command>& commands, const std::vector<std::string>& copies = {},
                                  const Look& look = {}, NotePrinters speakers = NotePrinters::each);

// The exit code of a whole chain: that of the first stage that failed by itself; 0 if none failed.  Two failures have
// their cause in a neighbour: exit code 4 (the stage before stopped writing) and SIGPIPE (the stage behind stopped
// reading).  They count only if no other failure is found.  `who`: set to the index of the failed stage.
int verdict(const std::vector<ProcessEnd>& ended, std::size_t& who);

} // namespace filum::app::filum
