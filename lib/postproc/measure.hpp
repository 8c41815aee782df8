// The readings of a toolpath before its program is written: where it goes, and what it will hold.
#pragma once

#include "postproc/survey.hpp"

#include <memory>

namespace filum::postproc {

// Takes the spans of a toolpath, in their order; again from the first while again() says so.
//
// Placing: with three axes the middle of all that is visited goes to the middle of the bed.  On a machine with rotary
// axes the part must be placed before the axes are worked out: the middle of the beads' box goes to the turn axis if
// that carries the part, else to the middle of the bed; so they are read twice.
class Measure {
  public:
    Measure(const machine::Profile& profile, Place place);
    void add(const toolpath::Span& span);
    bool again(); // ends a reading: another is wanted
    // Throws as Surveyor and check_limits do.
    Survey end();

    [[nodiscard]] Vec2 walk_shift() const { return rotary_ ? shift_ : Vec2{}; }    // for walker()
    [[nodiscard]] Vec2 program_shift() const { return rotary_ ? Vec2{} : shift_; } // for Program

  private:
    const machine::Profile* profile_;
    Place place_;
    bool rotary_;
    Surveyor surveyor_;
    std::unique_ptr<Walker> walk_; // none while only the box is sought
    geom::Box2 box_;               // of the beads
    Vec2 shift_;
};

} // namespace filum::postproc
