// Curves that are cut open and connected to each other, and the order of their parts that results
// (docs/algorithms/weave.md). Only arc lengths are known here; the caller knows the places.
#pragma once

#include "base/none.hpp"
#include "geom/disjoint_sets.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace filum::weave {

// A part of a curve that is cut out: forwards from `from` to `to` >= from, mm of arc length.
struct Window {
    std::uint32_t curve = 0;
    double from = 0, to = 0;
};

// An end of the remaining curve at a window: before the window, or after it.
struct End {
    std::uint32_t window = 0;
    bool after = false;
};

// A remaining part of a curve, and the link that follows it.
struct Step {
    std::uint32_t curve = 0;
    double from = 0, to = 0;    // mm, from < to
    bool backwards = false;     // runs from `to` to `from`
    std::uint32_t link = kNone; // kNone: nothing follows, or the same curve goes on
    bool link_backwards = false;
};

// A curve that results.
struct Trace {
    std::vector<Step> steps;
    bool closed = true;
    std::uint32_t tail = kNone; // the tail before the first step, to be followed backwards; kNone: none
};

class Weave {
  public:
    // Closed curves of these lengths, mm.
    explicit Weave(std::vector<double> lengths);

    [[nodiscard]] double length(std::uint32_t curve) const { return lengths_[curve]; }

    // Makes a curve open: it begins and ends at arc length 0.
    void open(std::uint32_t curve) { cut({curve, 0, 0}); }

    // Whether a window is shorter than its curve and overlaps no window that was cut before.
    [[nodiscard]] bool free(const Window& window) const;

    // Cuts a window out, which must be free. Returns its number.
    std::uint32_t cut(const Window& window);

    // Connects two ends by a link that leads from a to b, and unites their curves. Returns the number of the link.
    std::uint32_t link(End a, End b);

    // A link from the end a that leads nowhere else. Returns its number.
    std::uint32_t tail(End a);

    // An exchange (Lemma 1 of Sun, Yao, Jiang 2019): cuts a window out of each of two curves and links the four ends,
    // so that two closed curves become one. The first link leads from the end before window a, the second from the end
    // after it. With `same`, the curves run in the same direction, and the first link leads to the end before window b.
    // Returns the numbers of the links.
    std::array<std::uint32_t, 2> exchange(const Window& a, const Window& b, bool same);

    // The curves that are connected by links.
    [[nodiscard]] geom::DisjointSets& groups() { return groups_; }

    // The curves that result. Every end has at most one link. Open ones come first; each begins at its least free end.
    // Parts are ordered by curve and arc length, ends by part.
    [[nodiscard]] std::vector<Trace> traces() const;

  private:
    struct Link {
        End from, to;
        bool tail = false;
    };
    struct Parts; // the remaining parts of all curves, with their connections
    [[nodiscard]] Parts parts() const;
    [[nodiscard]] static Trace trace(const Parts& parts, std::uint32_t part, bool last, std::vector<char>& seen);

    std::vector<double> lengths_;
    std::vector<Window> windows_;                // with 0 <= from < length
    std::vector<std::vector<std::uint32_t>> of_; // per curve its windows
    std::vector<Link> links_;
    geom::DisjointSets groups_;
};

} // namespace filum::weave
