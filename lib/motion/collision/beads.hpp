// Converts a toolpath to moves and to the beads that they leave.
#pragma once

#include "collision/check.hpp"
#include "toolpath/path.hpp"

#include <deque>
#include <string>
#include <vector>

namespace filum::collision {

// Moves and the beads that they deposit. The nozzle itself shapes the last stretch of bead, as long as the bead is
// wide plus the diameter of the nozzle's flat; that stretch is no obstacle to it. A bead exists once its move has
// ended.
class BeadGrowth {
  public:
    explicit BeadGrowth(Heads heads) : heads_(std::move(heads)) {}
    // Adds the move, whose `before` is set here. Width 0: no bead. Returns false, and adds nothing, if it does not
    // move.
    bool add(Move move, double width, double height);

    std::vector<Move> moves;
    std::vector<Solid> beads; // in the order in which they are born

  private:
    Heads heads_;
    double way_ = 0, fresh_ = 0; // mm: distance so far; length of the fresh bead
    std::deque<double> ends_;    // arc lengths of the ends of fresh beads
};

// Appends moves of the idle heads that hang beside the tool in use, if the moves use both tools: the same moves,
// shifted. Moves of a carriage whose rotation is unknown are left out, as the place of the idle head is then unknown,
// too.
void add_idle(const Heads& heads, std::vector<Move>& moves);

struct Machine {
    Heads head;
    double lift = 0.6;     // mm above everything printed, of travels without normals
    double min_length = 0; // mm; shorter travels are not raised
    bool rotary = false;   // the carriage may be rotated about the tool axis by an unknown angle
};

// Reads spans in their order. Points with normals are followed as given; where the tool axis changes between two
// spans, the tool rotates on the spot. A travel without normals rises first, as postproc makes it: above all beads so
// far and above its own points. The carriage's x is the part's on three-axis machines, on spans without normals of
// unknown machines, and on travels from there with vertical normals; otherwise the carriage is treated as round.
class MoveReader {
  public:
    explicit MoveReader(const Machine& machine) : growth(machine.head), machine_(machine) {}
    void add(const toolpath::Span& span);
    BeadGrowth growth;

  private:
    void go(const ToolFrame& to, const toolpath::Span& span, double width, double height);
    [[nodiscard]] ToolFrame stance(const toolpath::Span& span, std::size_t i) const;
    void travel(const toolpath::Span& span);

    Machine machine_;
    ToolFrame at_;
    double top_ = 0;
    std::uint32_t points_ = 0; // number of points read
    bool started_ = false;
};

} // namespace filum::collision
