// How far a print has come, in the machine's own time.
#pragma once

#include "postproc/walk.hpp"

#include <vector>

namespace filum::postproc {

// Adds up what steps take at their feeds, without accelerations: no time, but one that is known at every move.
class Nominal {
  public:
    double add(const Step& step); // of all steps so far, s
    [[nodiscard]] double seconds() const { return sum_; }

  private:
    Vec3 at_;
    double sum_ = 0;
    bool placed_ = false;
};

// Where one kind of time is another: known where strokes begin and end, in proportion between.
struct Timeline {
    std::vector<double> nominal, seconds; // both ascending
    [[nodiscard]] double seconds_at(double nominal_seconds) const;
    [[nodiscard]] double total() const { return seconds.empty() ? 0 : seconds.back(); }
};

} // namespace filum::postproc
