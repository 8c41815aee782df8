// Windows cut out of rings, and the links that replace them: joins rings into one curve. Private to lib/fill.
#pragma once

#include "base/none.hpp"
#include "fill/join/ring_graph.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill::join {

using toolpath::Curve;

// The share of a link at either end that counts as part of the ring: it touches the ring and is as wide.
inline constexpr double kLinkEnd = 0.02;

// A stretch of a ring that is cut out: from s0 to s1 > s0.
struct Window {
    std::uint32_t ring = 0;
    double s0 = 0, s1 = 0;
};

// One end of a window, where the rest of the ring stops or continues.
struct Rim {
    std::uint32_t window = 0; // index in Splice::windows
    bool end = false;         // true: at s1; false: at s0
};

// The bead from rim to rim, without the points of the rims.
struct Link {
    Rim from, to;
    Curve bead{};
};

// Windows of different rings, and links that connect all their rims, so that the rings become one curve (Lemma 1 for
// two rings).
struct Splice {
    std::vector<Window> windows;
    std::vector<Link> links;
};

class Splices {
  public:
    explicit Splices(const RingGraph& graph);

    // True if no window overlaps the stretch of `ring` from s0 to s1, and the stretch is shorter than the ring.
    [[nodiscard]] bool free(std::uint32_t ring, double s0, double s1) const;
    void add(Splice splice);

    // The curves after all splices. Open curves come first, in the order of the open lines that they start with; then
    // closed curves, the longest first. Rings without windows stay as they were.
    [[nodiscard]] std::vector<Curve> trace() const;

  private:
    struct End {
        std::uint32_t arc = kNone; // kNone: the end of an open curve
        bool last = false;         // true: the last point of the arc; false: its first
    };
    struct Arc { // the stretch of a ring between two windows
        std::uint32_t ring;
        double s0, s1;
        End next[2];         // the ends that the links at its first and last point lead to
        const Link* link[2]; // nullptr: leads straight on, or nowhere
        bool along[2];       // true: the link runs forwards from here; false: backwards
    };
    [[nodiscard]] std::vector<Arc> arcs() const;
    void walk(const Arc& arc, bool backwards, Curve& line) const;

    const RingGraph* graph_;
    std::vector<std::vector<std::pair<double, double>>> used_; // per ring
    std::vector<Splice> splices_;
};

} // namespace filum::fill::join
