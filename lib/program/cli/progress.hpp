// Progress of a program, shown on a terminal or sent to the front command.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

namespace filum::cli {

struct Io;

// The progress as text: "NAME [####   ]  40 %". With `expected` 0 it is "NAME: DONE", or "NAME" if nothing is done yet.
std::string bar(const std::string& name, std::uint64_t done, std::uint64_t expected);

// Counts finished steps, and Clock shows the count. If the environment variable FILUM_PROGRESS names a file descriptor,
// lines "PROGRAM DONE EXPECTED" are written to it, every 16 steps and at the end.
class Progress {
  public:
    Progress(const Io& io, std::uint64_t expected); // 0: unknown, counts only
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step() { reach(done_ + 1); }
    void reach(std::uint64_t done); // sets the number of finished steps; a smaller number than before is ignored

  private:
    std::string program_;
    std::uint64_t expected_ = 0, done_ = 0;
    int told_ = -1; // file descriptor
};

// Shows a status line on standard error while it exists, from the first second on, redrawn each second. The line holds
// the name of the program, its progress and the seconds since its start. No line is shown if standard error is no
// terminal, with --quiet, or if FILUM_PROGRESS is set. No line is shown either if results go to the terminal or to a
// pipe; in a pipeline the last stage shows it.
class Clock {
  public:
    explicit Clock(const Io& io);
    ~Clock(); // clears the line
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

  private:
    std::jthread ticks_;
};

} // namespace filum::cli
