// The positions of a machine's axes, and the pose of the tool that they give.
#pragma once

#include "ingest/beads.hpp"
#include "machine/codes.hpp"

#include <functional>

namespace filum::ingest {

class Axes {
  public:
    explicit Axes(const machine::Profile& profile);

    machine::AxisNumbers at{}; // mm and degrees, as the program writes them

    void take(std::uint32_t tool) { tool_ = tool; }
    [[nodiscard]] std::uint32_t tool() const { return tool_; }
    // From now on X, Y and Z are those of the tip (`tip`), or of the axes.  The tool does not move.
    void mean_tip(bool tip);
    [[nodiscard]] Place place(const machine::AxisNumbers& numbers) const;

    // Moves the axes straight to `to`, in pieces so short that the tip moves straight, too. Calls `piece` with both
    // ends of each piece and its share of the whole move.
    using PieceVisitor = std::function<void(const Place& from, const Place& to, double share)>;
    void move(const machine::AxisNumbers& to, const PieceVisitor& piece) { part(to, 1, 0, piece); }

  private:
    void stand(const kinematics::Joints& joints);
    void part(const machine::AxisNumbers& to, double share, int depth, const PieceVisitor& piece);

    const machine::Profile* p_;
    std::uint32_t tool_ = 0;
    bool tip_ = true;
};

} // namespace filum::ingest
