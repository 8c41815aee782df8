// The moves of a program put together to a toolpath: strokes, travels, joins, and beads of one section.
#pragma once

#include "toolpath/path.hpp"

#include <functional>
#include <string>
#include <vector>

namespace filum::ingest {

using geom::Vec3;

// Where a program has the tool.
struct Place {
    Vec3 tip, axis{0, 0, 1};
};

// What a move lays.
struct Laid {
    double volume = 0; // mm3
    double unsure = 0; // mm3: by how much the volume may be off, as the program has so many decimals
    double height = 0; // mm
    std::uint32_t layer = 0, tool = 0;
    toolpath::Role role = toolpath::Role::bead;
    toolpath::Feature feature = toolpath::Feature::none;
};

// What the moves are, counted as they come.  A gap is what lies between two that lay material along the bed.
//   stop        a gap whose way in XY is longer than 0.05 mm, or in which material is taken back
//   travel      a gap whose way in XY is longer than 0.5 mm
//   stroke      ends at a gap that leads more than 0.5 mm aside or up or down by more than two layers, or in which
//               material is taken back
//   retraction  material taken back, once however many moves do it
struct Counts {
    std::uint64_t strokes = 0, stops = 0, travels = 0, retractions = 0;
    double extruded = 0, travelled = 0; // mm in space, mm in XY
    double volume = 0;                  // mm3
    double still = 0;                   // mm3 pushed out where the tool stands, beyond what was taken back
};

// Puts moves together.  Spans come as they are complete: neighbouring moves whose sections are equal, as far as the
// program's decimals can tell, share one, so that the volume of the whole is the sum of theirs.  A gap straight up by
// at most two layers, with nothing taken back, is a lift.
class Beads {
  public:
    using Emit = std::function<void(const toolpath::Span&)>;
    // `leans`: the tool may lean, and spans have normals.
    Beads(bool leans, Emit emit) : leans_(leans), emit_(std::move(emit)) {}

    void stand(const Place& at); // where the tool is before the first move, or after nobody knew
    void lay(const Place& to, const Laid& what);
    void go(const Place& to, bool takes = false); // `takes`: material is taken back on the way
    void take_back(double volume);                // mm3; while the tool stands or moves
    void push(double volume);                     // mm3, while it stands
    Counts finish();
    [[nodiscard]] const Counts& counts() const { return counts_; }

  private:
    void close_run();
    void close_gap(const Laid& next);
    void begin_run(const Laid& what);

    bool leans_;
    Emit emit_;
    Counts counts_;
    Place at_;
    toolpath::Span run_;                       // beads of one section, open
    Laid laid_;                                // its volume is that of the run
    double length_ = 0, least_ = 0, most_ = 0; // of the run: mm; bounds of its section, mm2
    std::vector<Place> gap_;                   // since the last bead, its end first
    double gap_way_ = 0;                       // mm in XY
    std::uint64_t retractions_ = 0;            // in the gap
    bool begun_ = false, taken_ = false, taking_ = false;
    double owed_ = 0; // mm3 taken back and not yet given again
};

} // namespace filum::ingest
