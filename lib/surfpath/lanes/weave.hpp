// Lanes cut open here and there, and their ends joined otherwise.
#pragma once

#include "surfpath/lanes/lanes.hpp"

namespace filum::surfpath::lanes {

// An end of what remains of a lane beside a window: before it, or after it in the direction of the lane.
struct LaneEnd {
    std::uint32_t window = 0;
    bool after = false;
};

class Weave {
  public:
    explicit Weave(const Lanes& lanes) : lanes_(lanes), of_(lanes.size()) {}

    // True if no window comes nearer than `margin` mm to the stretch of the lane that runs forwards between the ways.
    [[nodiscard]] bool free(std::uint32_t lane, double from, double to, double margin) const;

    // Cuts the lane from `from` forwards to `to`; that is free.  Returns the window.
    std::uint32_t cut(std::uint32_t lane, double from, double to);

    // Joins two ends by a line from the first to the second; a line from the first to nowhere.
    void link(LaneEnd a, LaneEnd b, Line line);
    void tail(LaneEnd a, Line line);

    // The lines that come of it: open ones by their first free ends, then closed ones.
    struct Course {
        Line line;
        bool closed = false;
        std::vector<std::uint32_t> lanes; // that it follows, ascending
    };
    [[nodiscard]] std::vector<Course> courses() const;

  private:
    struct Window {
        std::uint32_t lane;
        double from, length;
    };
    struct Link {
        LaneEnd to;
        Line line;
        bool open = false; // leads nowhere
    };
    [[nodiscard]] std::size_t index(LaneEnd e) const { return 2 * std::size_t{e.window} + (e.after ? 1 : 0); }
    [[nodiscard]] Line arc(LaneEnd from, LaneEnd& to) const;
    [[nodiscard]] Course follow(LaneEnd from, std::vector<char>& seen) const;

    const Lanes& lanes_;
    std::vector<Window> windows_;
    std::vector<std::vector<std::uint32_t>> of_; // per lane: its windows
    std::vector<Link> links_;                    // per end
    std::vector<char> linked_;
};

} // namespace filum::surfpath::lanes
