// Slows moves down where a controller cannot take so many per second.
#pragma once

#include "postproc/walk.hpp"

namespace filum::postproc {

// The number of moves that a controller plans together, and the least time for so many moves, s (0: no limit).
struct Pace {
    std::size_t moves = 1;
    double seconds = 0;
};
Pace pace(const machine::Profile& profile);

// For consecutive moves that take `seconds`: the factor, at least 1, by which each must take longer.  Then any
// pace.moves of them take at least pace.seconds.  All moves of a group that is too quick get the same factor; a move of
// several groups gets the largest.
std::vector<double> slowdowns(std::span<const double> seconds, const Pace& pace);

// Multiplies `seconds` by these factors; returns the number of moves that became slower.
std::uint64_t slow_down(std::span<double> seconds, const Pace& pace);

// Hands steps on in batches, with the feeds of extruding moves lowered to the profile's pace.  Any other act between
// two such moves, except a layer mark, takes long enough for the controller to catch up.  A lowered feed above 1 mm/s
// is a whole number.
class Throughput {
  public:
    Throughput(const machine::Profile& profile, Steps out);
    void add(const Step& step);
    void end();
    [[nodiscard]] std::uint64_t slowed() const { return slowed_; } // moves slowed so far

  private:
    void release(bool all);
    void settle(std::size_t first, std::size_t last);
    Pace pace_;
    Steps out_;
    std::vector<Step> steps_;
    std::vector<double> factors_; // by step of steps_
    std::uint64_t slowed_ = 0;
};

} // namespace filum::postproc
