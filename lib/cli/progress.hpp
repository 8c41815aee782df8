// How far a program is, for whoever waits at a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

namespace filum::cli {

struct Io;

// "NAME [####   ]  40 %"; with nothing expected "NAME: DONE", with nothing done either "NAME".
std::string bar(const std::string& name, std::uint64_t done, std::uint64_t expected);

// Counts what is done.  Clock draws it; where the environment variable FILUM_PROGRESS names a file descriptor, lines
// "PROGRAM DONE EXPECTED" go there instead, every 16 steps and at the end.
class Progress {
  public:
    Progress(const Io& io, std::uint64_t expected); // 0: unknown, counts only
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void step() { reach(done_ + 1); }
    void reach(std::uint64_t done); // what is done in all; never less than before

  private:
    std::string program_;
    std::uint64_t expected_ = 0, done_ = 0;
    int told_ = -1; // file descriptor
};

// As long as it lives, a line on standard error from the first second on, drawn anew each second: the program, how far
// it is if it counts, and since when it runs.  Only on a terminal, unless --quiet; not where results go to that
// terminal, or to a pipe, whose last stage shows it; nor with FILUM_PROGRESS.
class Clock {
  public:
    explicit Clock(const Io& io);
    ~Clock(); // wipes the line
    Clock(const Clock&) = delete;
    Clock& operator=(const Clock&) = delete;

  private:
    std::jthread ticks_;
};

} // namespace filum::cli
