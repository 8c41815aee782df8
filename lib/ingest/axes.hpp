// Where the axes of a machine are, and where that puts the tool.
#pragma once

#include "ingest/beads.hpp"
#include "machine/codes.hpp"

#include <functional>

namespace filum::ingest {

class Axes {
  public:
    explicit Axes(const machine::Profile& profile);

    machine::AxisNumbers at{}; // as the program has them: mm, degrees

    void take(std::uint32_t tool) { tool_ = tool; }
    [[nodiscard]] std::uint32_t tool() const { return tool_; }
    // X, Y and Z mean the tip from here on, or where the axes stand; the tool stays where it is.
    void mean_tip(bool tip);
    [[nodiscard]] Place place(const machine::AxisNumbers& numbers) const;

    // A straight move of the axes, as pieces on which the tip goes straight, too: `piece` gets both ends and which
    // share of the move it is.  Moves there.
    using Piece = std::function<void(const Place& from, const Place& to, double share)>;
    void move(const machine::AxisNumbers& to, const Piece& piece) { part(to, 1, 0, piece); }

  private:
    void stand(const kinematics::Joints& joints);
    void part(const machine::AxisNumbers& to, double share, int depth, const Piece& piece);

    const machine::Profile* p_;
    std::uint32_t tool_ = 0;
    bool tip_ = true;
};

} // namespace filum::ingest
