// The progress of a print in the machine's own time.
#pragma once

#include "postproc/walk.hpp"

#include <vector>

namespace filum::postproc {

// Adds up the nominal time: what steps take at their feeds, without accelerations.  It is not the time of the print,
// but it is known at every move.
class Nominal {
  public:
    double add(const Step& step); // returns the nominal time of all steps so far, s
    [[nodiscard]] double seconds() const { return sum_; }

  private:
    Vec3 at_;
    double sum_ = 0;
    bool placed_ = false;
};

// Converts nominal time to the machine's: known where strokes begin and end, and in proportion between these.
struct Timeline {
    std::vector<double> nominal, seconds; // s, both ascending
    [[nodiscard]] double seconds_at(double nominal_seconds) const;
    [[nodiscard]] double total() const { return seconds.empty() ? 0 : seconds.back(); }
};

} // namespace filum::postproc
