// Ways along rims and rows from the end of one row to that of another that is farther off.
#pragma once

#include "surfpath/rows/rows.hpp"

#include <optional>

namespace filum::surfpath::rows {

// Ends of rows are numbered as in order.hpp.  Rows and what the inset is made of must outlive it.
class Transits {
  public:
    explicit Transits(const Rows& rows);

    struct Way {
        double length = 0;           // mm
        std::vector<Line> stretches; // along rings and rows, one after the other; corners between them
    };

    // The shortest way from one end to another along the inset and along rows other than their own; of equal ones the
    // one over the least ends.  None if they do not hang together.
    [[nodiscard]] std::optional<Way> way(std::uint32_t from, std::uint32_t to) const;

    // Its length, mm; infinite if there is none.
    [[nodiscard]] double length(std::uint32_t from, std::uint32_t to) const { return search(from, to).length[to]; }

    // Whether no other end lies between the two on their ring.
    [[nodiscard]] bool next_to(std::uint32_t a, std::uint32_t b) const;

    // The shorter way along the ring that both ends lie on; empty if they lie on different ones, or it is open between.
    [[nodiscard]] Line along(std::uint32_t from, std::uint32_t to) const;

  private:
    struct Step {
        std::uint32_t to;
        double length;
        bool row; // along the row, not the ring: a ring may lead from one end of a row to the other, too
    };
    struct Tree {
        std::vector<double> length;
        std::vector<std::uint32_t> before;
        std::vector<char> by_row; // from there
    };
    [[nodiscard]] Tree search(std::uint32_t from, std::uint32_t to) const;

    const Rows& rows_;
    std::vector<std::vector<Step>> steps_; // per end
};

// In which order and direction chains follow each other so that the ways between them are short.  `length(a, b)` is
// that from the end of one to the begin of another: ends are 2 c, the begin of chain c, and 2 c + 1.  Exact for up to
// eight chains; of more the better of nearest neighbours, and always the shortest way that joins two still apart.
struct Turned {
    std::uint32_t chain = 0;
    bool reversed = false;
};
std::vector<Turned> tour(const std::vector<std::vector<double>>& length);

} // namespace filum::surfpath::rows
