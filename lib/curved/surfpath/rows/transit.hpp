// Transits: ways along rims and rows between ends of rows that no turn connects.
#pragma once

#include "surfpath/rows/rows.hpp"

#include <optional>

namespace filum::surfpath::rows {

// Ends of rows are numbered as in plan/order.hpp. `rows` must outlive the object.
class Transits {
  public:
    explicit Transits(const Rows& rows);

    struct Transit {
        double length = 0;           // mm
        std::vector<Line> stretches; // parts along rings and rows; between these are corners
    };

    // The shortest transit from one end to another along the inset and along rows, except the rows of these ends.
    // Ties: the one over the ends of lower number. None if they are not connected.
    [[nodiscard]] std::optional<Transit> shortest(std::uint32_t from, std::uint32_t to) const;

    // Its length, mm; infinite if there is none.
    [[nodiscard]] double length(std::uint32_t from, std::uint32_t to) const { return search(from, to).length[to]; }

    // Whether the two ends are neighbours on their ring.
    [[nodiscard]] bool next_to(std::uint32_t a, std::uint32_t b) const;

    // The shorter way along the ring that contains both ends; empty if they are on different rings, or the ring is
    // open in between.
    [[nodiscard]] Line along(std::uint32_t from, std::uint32_t to) const;

  private:
    struct Edge {
        std::uint32_t to;
        double length;
        bool row; // along the row rather than the ring, which may also connect the two ends of a row
    };
    struct PathTree {
        std::vector<double> length;
        std::vector<std::uint32_t> before;
        std::vector<char> by_row; // whether the edge that leads here follows a row
    };
    [[nodiscard]] PathTree search(std::uint32_t from, std::uint32_t to) const;

    const Rows& rows_;
    std::vector<std::vector<Edge>> edges_; // per end
};

// An order and directions of chains such that the ways between them are short. length[a][b] is the way from the end of
// one chain to the begin of another: end 2 c is the begin of chain c, 2 c + 1 its end. Optimal for up to eight chains;
// for more the better of two heuristics: nearest neighbour, and shortest ways first.
struct OrientedChain {
    std::uint32_t chain = 0;
    bool reversed = false;
};
std::vector<OrientedChain> tour(const std::vector<std::vector<double>>& length);

} // namespace filum::surfpath::rows
