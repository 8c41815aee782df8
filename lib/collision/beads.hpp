// The moves of a toolpath, and the beads that they leave behind.
#pragma once

#include "collision/check.hpp"
#include "toolpath/path.hpp"

#include <deque>
#include <string>
#include <vector>

namespace filum::collision {

// Moves and the beads they lay.  The bead of the last stretch of the way, as long as it is wide plus the flat's
// diameter, is shaped by the nozzle itself and does not stand in its way; a bead is there once its move has ended.
class Growth {
  public:
    explicit Growth(Heads heads) : heads_(std::move(heads)) {}
    // Adds the move; its `before` is set here.  A width of 0 lays nothing.  Returns false, and adds nothing, if it
    // does not move.
    bool add(Move move, double width, double height);

    std::vector<Move> moves;
    std::vector<Solid> beads; // born in their order

  private:
    Heads heads_;
    double way_ = 0, fresh_ = 0; // mm: gone so far; how long the fresh bead is
    std::deque<double> ends_;    // of the fresh beads along the way
};

struct Machine {
    Heads head;
    double lift = 0.6;     // mm, of travels without normals above all that is printed
    double min_length = 0; // mm; shorter ones stay where they are
    bool rotary = false;   // the carriage may be turned about the tool axis, nobody knows how
};

// Spans in their order.  Points with normals are followed as they say; a tool axis that changes between two spans
// turns where it stands.  A travel without normals rises first, as postproc makes it: above all beads so far and its
// own points. The carriage's x is the part's on machines with three axes and on spans without normals of no known
// machine, and on travels from there whose normals are upright; otherwise it is taken as round.
class Walk {
  public:
    explicit Walk(const Machine& machine) : growth(machine.head), machine_(machine) {}
    void add(const toolpath::Span& span);
    Growth growth;

  private:
    void go(const Stance& to, const toolpath::Span& span, double width, double height);
    [[nodiscard]] Stance stance(const toolpath::Span& span, std::size_t i) const;
    void travel(const toolpath::Span& span);

    Machine machine_;
    Stance at_;
    double top_ = 0;
    std::uint32_t points_ = 0; // read so far
    bool started_ = false;
};

} // namespace filum::collision
