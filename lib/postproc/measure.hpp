// The readings of a toolpath before its program is written: where it goes, and what it will hold.
#pragma once

#include "postproc/survey.hpp"
#include "postproc/turning.hpp"

#include <memory>

namespace filum::postproc {

// Takes the spans of a toolpath, in their order; again from the first while again() says so.
//
// Placing: with three axes the middle of all that is visited goes to the middle of the bed.  On a machine with rotary
// axes the part must be placed before the axes are worked out: turned first, then the middle of the beads' box goes to
// the turn axis if that carries the part, else to the middle of the bed, and its lowest point where it was before it
// was turned; so they are read twice.  Spans are given as they came.
class Measure {
  public:
    // Throws Error(usage) for a turn on a machine of three axes.
    Measure(const machine::Profile& profile, Place place, const Orient& orient = {});
    void add(const toolpath::Span& span);
    // Throws Error(failure) if a tool axis of the beads is beyond the tilts of the machine, saying what it would need.
    bool again(); // ends a reading: another is wanted
    // Throws as Surveyor and check_limits do.
    Survey end();

    // As it goes to walker(): turned, and back at its height.
    [[nodiscard]] toolpath::Span turned(toolpath::Span span) const;
    [[nodiscard]] Vec2 walk_shift() const { return rotary_ ? shift_ : Vec2{}; }    // for walker()
    [[nodiscard]] Vec2 program_shift() const { return rotary_ ? Vec2{} : shift_; } // for Program

  private:
    const machine::Profile* profile_;
    Place place_;
    bool rotary_;
    Surveyor surveyor_;
    std::unique_ptr<Walker> walk_; // none while only the box is sought
    void see(const toolpath::Span& span);
    [[nodiscard]] std::string placed() const; // for the head of the program; nothing with three axes
    void check_tilts() const;
    bool automatic_;              // the turn is to be found
    bool automatic_done_ = false; // and was
    Turning turning_;
    std::vector<Vec3> axes_;  // of beads: only while an automatic turn is sought
    geom::Box2 box_;          // of the beads, turned
    double low_, turned_low_; // their lowest z, as they came and turned
    double tilt_ = -1;        // rad: the most that a tool axis of theirs is off upright
    Vec3 tilt_at_;
    Vec2 shift_;
    double rise_ = 0; // mm, of what is turned
};

} // namespace filum::postproc
