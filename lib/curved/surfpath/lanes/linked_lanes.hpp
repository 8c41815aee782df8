// Lanes that are cut open and connected to each other by lines.
#pragma once

#include "surfpath/lanes/lanes.hpp"
#include "weave/weave.hpp"

namespace filum::surfpath::lanes {

class LinkedLanes {
  public:
    explicit LinkedLanes(const Lanes& lanes);

    // The window of the lane that leads forwards from `from` to `to`.
    [[nodiscard]] weave::Window window(std::uint32_t lane, double from, double to) const;

    // Whether a window is at least `margin` mm away from those that were cut before.
    [[nodiscard]] bool free(const weave::Window& window, double margin) const;

    // Cuts out a window, which must be free. Returns its number.
    std::uint32_t cut(const weave::Window& window) { return weave_.cut(window); }
    // Connects two ends by a line that leads from the first to the second.
    void link(weave::End a, weave::End b, Line line);
    // Extends an end by a line that leads nowhere else.
    void tail(weave::End a, Line line);
    // Exchanges two windows (Weave::exchange). `lines` lead from the ends of the first window to those of the second.
    void exchange(const weave::Window& a, const weave::Window& b, bool same, std::array<Line, 2> lines);

    // The lanes that are connected by links.
    [[nodiscard]] geom::DisjointSets& groups() { return weave_.groups(); }

    // The curves that result, in the order of Weave::traces.
    struct Curve {
        Line line;
        bool closed = false;
        std::vector<std::uint32_t> lanes; // lanes that it contains parts of, ascending

        // Moves the line out. A closed one is marked as closed and does not repeat its first place; an open one begins
        // at `begin` if it ends there.
        Line take(const geom::Vec3& begin);
    };
    [[nodiscard]] std::vector<Curve> curves() const;

  private:
    [[nodiscard]] Curve curve(const weave::Trace& trace) const;

    const Lanes& lanes_;
    weave::Weave weave_;
    std::vector<Line> lines_; // of the links
};

} // namespace filum::surfpath::lanes
