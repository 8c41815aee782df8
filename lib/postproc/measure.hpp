// The readings of a toolpath before its program is written: where it goes, and what it will hold.
#pragma once

#include "postproc/first_pass.hpp"
#include "postproc/turning.hpp"
#include "toolpath/extent.hpp"

#include <memory>

namespace filum::postproc {

// Takes the spans of a toolpath, in their order; again from the first while again() says so: what does not fill must be
// known before what does is merged.
//
// Placing: with three axes the middle of all that is visited goes to the middle of the bed.  On a machine with rotary
// axes the part must be placed before the axes are worked out: turned first, then the middle of the beads' box goes to
// the turn axis if that carries the part, else to the middle of the bed, and its lowest point where it was before it
// was turned; so they are read twice.  Spans are given as they came.
class Measure {
  public:
    // Throws Error(usage) for a turn on a machine of three axes.  `flatten`: one of three axes may follow a path that
    // leans the tool farther than its upright nozzle can.
    Measure(const machine::Profile& profile, Place place, const Orient& orient = {}, bool flatten = false,
            machine::Pauses pauses = {});
    // `merged`: as Walker::add takes it.
    void add(const toolpath::Span& span, const toolpath::Merged* merged = nullptr);
    // Throws Error(failure) if a tool axis of the beads is beyond the tilts of the machine, saying what it would need.
    bool again(); // ends a reading: another is wanted
    // Throws Error(failure) where the toolpath leans the tool too far for an upright nozzle, and as Surveyor and
    // check_limits do.
    FirstPass end();

    // As it goes to walker(): turned, and back at its height.
    [[nodiscard]] toolpath::Span turned(toolpath::Span span) const;
    [[nodiscard]] const Joins* joins() const { return &joins_; }                   // likewise; of the first reading
    [[nodiscard]] Vec2 walk_shift() const { return rotary_ ? shift_ : Vec2{}; }    // for walker()
    [[nodiscard]] Vec2 program_shift() const { return rotary_ ? Vec2{} : shift_; } // for Program

  private:
    const machine::Profile* profile_;
    Place place_;
    bool rotary_;
    Surveyor surveyor_;
    std::unique_ptr<Walker> walk_; // none while only the box is sought, or what does not fill
    Joins joins_;
    void see(const toolpath::Span& span);
    [[nodiscard]] std::string placed() const; // for the head of the program; nothing with three axes
    void check_tilts() const;
    void see_upright(const toolpath::Span& span);
    void check_upright() const;
    bool automatic_;              // the turn is to be found
    bool automatic_done_ = false; // and was
    Turning turning_;
    std::vector<Vec3> axes_;  // of beads: only while an automatic turn is sought
    geom::Box2 box_;          // of the beads, turned
    toolpath::Extent part_;   // as it is printed: turned
    double low_, turned_low_; // their lowest z, as they came and turned
    double tilt_ = -1;        // rad: the most that a tool axis of theirs is off upright
    Vec3 tilt_at_;
    bool flatten_ = false;
    double excess_ = 0; // rad: the most that such a tilt is beyond what an upright nozzle allows there
    double excess_tilt_ = 0, excess_height_ = 0; // rad, mm: there
    Vec3 excess_at_;
    Vec2 shift_;
    double rise_ = 0; // mm, of what is turned
};

} // namespace filum::postproc
