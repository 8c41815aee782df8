// Windows cut out of rings, and the links that replace them: joins rings into one curve. Private to lib/planar/fill.
#pragma once

#include "fill/join/ring_graph.hpp"
#include "weave/weave.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill::join {

using toolpath::Curve;

// The share of a link at either end that counts as part of the ring: it touches the ring and is as wide.
inline constexpr double kLinkEnd = 0.02;

// A link between two ends of a Splice, whose windows are numbered as there: the bead from end to end, without the
// points on the rings.
struct Link {
    weave::End from, to;
    Curve bead{};
};

// Windows of different rings, and links that connect all their ends, so that the rings become one curve (Lemma 1 for
// two rings).
struct Splice {
    std::vector<weave::Window> windows;
    std::vector<Link> links;
};

class Splices {
  public:
    explicit Splices(const RingGraph& graph);

    // True if no window overlaps the stretch of `ring` from s0 to s1, and the stretch is shorter than the ring.
    [[nodiscard]] bool free(std::uint32_t ring, double s0, double s1) const { return weave_.free({ring, s0, s1}); }
    void add(Splice splice);
    // The rings that are joined.
    [[nodiscard]] geom::DisjointSets& groups() { return weave_.groups(); }

    // The curves after all splices. Open curves come first, in the order of the open lines that they start with; then
    // closed curves, the longest first. Rings without windows stay as they were.
    [[nodiscard]] std::vector<Curve> trace() const;

  private:
    void walk(const weave::Step& step, Curve& line) const;

    const RingGraph* graph_;
    weave::Weave weave_;
    std::vector<Curve> beads_; // of the links
};

} // namespace filum::fill::join
