// Lanes that are cut open and connected to each other by links.
#pragma once

#include "surfpath/lanes/lanes.hpp"

namespace filum::surfpath::lanes {

// An end of a remainder of a lane at an opening: before it, or after it in the direction of the lane.
struct LaneEnd {
    std::uint32_t opening = 0;
    bool after = false;
};

class Weave {
  public:
    explicit Weave(const Lanes& lanes) : lanes_(lanes), of_(lanes.size()) {}

    // Whether every opening is at least `margin` mm away from the part of the lane that leads forwards from `from` to
    // `to`.
    [[nodiscard]] bool free(std::uint32_t lane, double from, double to, double margin) const;

    // Cuts out the part of the lane that leads forwards from `from` to `to`, which must be free. Returns the opening.
    std::uint32_t cut(std::uint32_t lane, double from, double to);

    // Connects two ends by a line that leads from the first to the second.
    void link(LaneEnd a, LaneEnd b, Line line);
    // Extends an end by a line that leads nowhere else.
    void tail(LaneEnd a, Line line);

    // The curves that result: open ones in the order of their first free ends, then closed ones.
    struct Curve {
        Line line;
        bool closed = false;
        std::vector<std::uint32_t> lanes; // lanes that it contains parts of, ascending
    };
    [[nodiscard]] std::vector<Curve> curves() const;

  private:
    struct Opening {
        std::uint32_t lane;
        double from, length;
    };
    struct Link {
        LaneEnd to;
        Line line;
        bool open = false; // a tail
    };
    [[nodiscard]] std::size_t index(LaneEnd e) const { return 2 * std::size_t{e.opening} + (e.after ? 1 : 0); }
    [[nodiscard]] Line remainder(LaneEnd from, LaneEnd& to) const;
    [[nodiscard]] Curve follow(LaneEnd from, std::vector<char>& seen) const;

    const Lanes& lanes_;
    std::vector<Opening> openings_;
    std::vector<std::vector<std::uint32_t>> of_; // per lane its openings
    std::vector<Link> links_;                    // per end
    std::vector<char> linked_;
};

} // namespace filum::surfpath::lanes
