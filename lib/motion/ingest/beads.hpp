// Joins the moves of a program to a toolpath: strokes, travels, lifts, and beads of one cross-section.
#pragma once

#include "toolpath/path.hpp"

#include <functional>
#include <string>
#include <vector>

namespace filum::ingest {

using geom::Vec3;

// The pose of the tool.
struct Place {
    Vec3 tip, axis{0, 0, 1};
};

// The bead that a move deposits.
struct DepositedBead {
    double volume = 0; // mm3
    double unsure = 0; // mm3: possible error of the volume, from the program's decimals
    double height = 0; // mm
    std::uint32_t layer = 0, tool = 0;
    toolpath::Role role = toolpath::Role::bead;
    toolpath::Feature feature = toolpath::Feature::none;
};

// Totals over the moves. A gap is the part of the path between two beads.
//    stop        a gap longer than 0.05 mm in XY, or one with a retraction
//    travel      a gap longer than 0.5 mm in XY
//    stroke      ends at a gap with a retraction, or whose ends are more than 0.5 mm apart in XY or two layers in z
//    retraction  material taken back; several moves in a row count once
struct Counts {
    std::uint64_t strokes = 0, stops = 0, travels = 0, retractions = 0;
    double extruded = 0, travelled = 0; // mm in space; mm in XY
    double volume = 0;                  // mm3
    double still = 0;                   // mm3 extruded while the tool stands, beyond what was retracted
};

// Joins moves to spans, and emits a span when it is complete. Neighbouring moves share a span if their cross-sections
// are equal, as far as the program's decimals can tell. So the volume of a span is the sum of theirs. A gap that is no
// stop and leads up by at most two layers is a lift.
class Beads {
  public:
    using Emit = std::function<void(const toolpath::Span&)>;
    // `leans`: the tool may lean, so spans have normals.
    Beads(bool leans, Emit emit) : leans_(leans), emit_(std::move(emit)) {}

    void stand(const Place& at); // sets the pose before the first bead
    void lay(const Place& to, const DepositedBead& what);
    void go(const Place& to, bool takes = false); // `takes`: the move retracts
    void take_back(double volume);                // retracts `volume` mm3, while the tool stands or moves
    void push(double volume);                     // extrudes `volume` mm3 while the tool stands
    Counts finish();
    [[nodiscard]] const Counts& counts() const { return counts_; }

  private:
    void close_run();
    void close_gap(const DepositedBead& next);
    void begin_run(const DepositedBead& what);

    bool leans_;
    Emit emit_;
    Counts counts_;
    Place at_;
    toolpath::Span run_;                       // the open span of beads with one cross-section
    DepositedBead bead_;                       // properties of the run, and its volume
    double length_ = 0, least_ = 0, most_ = 0; // length of the run, mm; bounds of its cross-section, mm2
    std::vector<Place> gap_;                   // poses since the last bead, starting with its end
    double gap_way_ = 0;                       // length of the gap in XY, mm
    std::uint64_t retractions_ = 0;            // retractions in the gap
    bool begun_ = false, taken_ = false, taking_ = false;
    double owed_ = 0; // mm3 retracted and not yet returned
};

} // namespace filum::ingest
