// No more moves at a time than a controller takes.
#pragma once

#include "postproc/walk.hpp"

namespace filum::postproc {

// How many moves a controller plans together, and how long as many must take, s (0: no matter).
struct Pace {
    std::size_t moves = 1;
    double seconds = 0;
};
Pace pace(const machine::Profile& profile);

// By how much each of consecutive moves of `seconds` must take longer, 1 or more, so that any pace.moves of them take
// pace.seconds at least: as much as all of a group that is too quick.
std::vector<double> slowdowns(std::span<const double> seconds, const Pace& pace);

// Makes consecutive moves of `seconds` take that much longer; returns how many do.
std::uint64_t slow_down(std::span<double> seconds, const Pace& pace);

// Hands steps on in batches, the feeds of moves that lay material lowered to the profile's pace.  Whatever else a
// machine does between two of them takes long enough to read on.  A lowered feed is a whole number where it is above
// one.
class Throughput {
  public:
    Throughput(const machine::Profile& profile, Steps out);
    void add(const Step& step);
    void end();
    [[nodiscard]] std::uint64_t slowed() const { return slowed_; } // moves, so far

  private:
    void release(bool all);
    void settle(std::size_t first, std::size_t last);
    Pace pace_;
    Steps out_;
    std::vector<Step> steps_;
    std::vector<double> factors_; // of steps_
    std::uint64_t slowed_ = 0;
};

} // namespace filum::postproc
