// Reads a toolpath before its program is written, to place it on the machine and to collect its first pass.
#pragma once

#include "postproc/first_pass.hpp"
#include "postproc/turning.hpp"
#include "toolpath/extent.hpp"

#include <memory>

namespace filum::postproc {

// Takes the spans of a toolpath in their order, unchanged, and again from the first one while again() returns true.
// Lifts, jogs and connectors of all layers must be known before the moves of beads are merged.
//
// Placing: with three axes the middle of all visited points goes to the middle of the bed.  With rotary axes the part
// must be placed before the axes are computed.  It is turned first.  Then the middle of the beads' box goes to the turn
// axis, if that carries the part, else to the middle of the bed.  The lowest point returns to its height before the
// turn.
class Measure {
  public:
    // `flatten`: a machine with three axes may follow a path that leans the tool farther than an upright nozzle allows.
    // Throws Error(usage) for a turn of the part on a machine with three axes.
    Measure(const machine::Profile& profile, Place place, const Orient& orient = {}, bool flatten = false,
            machine::Pauses pauses = {});
    // `merged`: see Walker::add.
    void add(const toolpath::Span& span, const toolpath::MergeResult* merged = nullptr);
    // Ends a reading; true if another one is needed.  Throws Error(failure) with the tilt needed if a bead leans the
    // tool farther than the machine tilts, or farther than an upright nozzle allows.
    bool again();
    // Ends the last reading, after again() returned false.  Throws as Surveyor and check_limits do.
    FirstPass end();

    // The span for walker(): turned, and moved back to its height.
    [[nodiscard]] toolpath::Span turned(toolpath::Span span) const;
    [[nodiscard]] const Joins* joins() const { return &joins_; }                   // for walker(); of the first reading
    [[nodiscard]] Vec2 walk_shift() const { return rotary_ ? shift_ : Vec2{}; }    // for walker()
    [[nodiscard]] Vec2 program_shift() const { return rotary_ ? Vec2{} : shift_; } // for Program

  private:
    const machine::Profile* profile_;
    Place place_;
    bool rotary_;
    Surveyor surveyor_;
    std::unique_ptr<Walker> walk_; // null until the last reading
    Joins joins_;
    void see(const toolpath::Span& span);
    [[nodiscard]] std::string placed() const; // for the head of the program; "" with three axes
    void check_tilts() const;
    void see_upright(const toolpath::Span& span);
    void check_upright() const;
    bool automatic_;              // the turn is still to be found
    bool automatic_done_ = false; // the turn was found
    Turning turning_;
    std::vector<Vec3> axes_;  // tool axes of beads, while automatic_
    geom::Box2 box_;          // of the turned beads
    toolpath::Extent part_;   // of the turned part
    double low_, turned_low_; // lowest z of the beads, before and after the turn
    double tilt_ = -1;        // rad: largest tilt of a bead's tool axis
    Vec3 tilt_at_;
    bool flatten_ = false;
    double excess_ = 0; // rad: largest excess of a tilt over what an upright nozzle allows there
    double excess_tilt_ = 0, excess_height_ = 0; // rad, mm: tilt and bead height at that place
    Vec3 excess_at_;
    Vec2 shift_;
    double rise_ = 0; // mm, added to z after the turn
};

} // namespace filum::postproc
