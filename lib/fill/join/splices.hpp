// Windows cut out of rings, and the beads laid instead: where rings become one curve.  Private to lib/fill.
#pragma once

#include "base/none.hpp"
#include "fill/join/ring_graph.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill::join {

using toolpath::Curve;

// Share of a link's length at either end that lies on rings, as good as: it is as wide as they are there, and touches
// them.
inline constexpr double kLinkEnd = 0.02;

// What a ring gives up: from s0 on to s1 > s0.
struct Window {
    std::uint32_t ring = 0;
    double s0 = 0, s1 = 0;
};

// One rim of a window: where the ring ends or goes on.
struct Rim {
    std::uint32_t window = 0; // of the splice
    bool end = false;         // at s1, else at s0
};

// The bead from rim to rim, without the rims' own points.
struct Link {
    Rim from, to;
    Curve bead{};
};

// Windows of different rings and the links that tie all their rims: the rings become one curve (Lemma 1 for two).
struct Splice {
    std::vector<Window> windows;
    std::vector<Link> links;
};

class Splices {
  public:
    explicit Splices(const RingGraph& graph);

    // Whether no window has taken any of `ring` between s0 and s1, and enough of it is left.
    [[nodiscard]] bool free(std::uint32_t ring, double s0, double s1) const;
    void add(Splice splice);

    // The curves that the rings have become, the longest first; rings without windows as they were.  Before them open
    // ones, in the order of the open lines that they begin as.
    [[nodiscard]] std::vector<Curve> trace() const;

  private:
    struct End {
        std::uint32_t arc = kNone; // else an end of an open curve
        bool last = false;         // the arc's last point, else its first
    };
    struct Arc { // what is left of a ring between two windows
        std::uint32_t ring;
        double s0, s1;
        End next[2];         // what the links at its first and last point lead to
        const Link* link[2]; // none if it leads straight on, or nowhere
        bool along[2];       // the link from its first point to its last, else backwards
    };
    [[nodiscard]] std::vector<Arc> arcs() const;
    void walk(const Arc& arc, bool backwards, Curve& line) const;

    const RingGraph* graph_;
    std::vector<std::vector<std::pair<double, double>>> used_; // per ring
    std::vector<Splice> splices_;
};

} // namespace filum::fill::join
