// What a head may meet, in a tree of boxes that knows since when each thing is there.
#pragma once

#include "collision/shape.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace filum::collision {

// All points nearer than `radius` to the convex hull of the corners: a triangle of a mesh (twice its last corner,
// radius 0), or a bead.
struct Solid {
    std::array<Vec3, 4> corner; // in order round it
    double radius = 0;          // mm
    std::uint32_t born = 0;     // present for whoever asks with a greater number
};

// The bead of `width` and `height` (mm) laid from stance `from` to `to`, whose tips ran along the middle of its top:
// the hull of two half-height rods along its sides.  One narrower than high is taken as broad as it is high.
Solid bead(const Stance& from, const Stance& to, double width, double height, std::uint32_t born);

// How a head moves while a question is asked: from one stance to another at even speed, the axis turning evenly, off
// that way by no more than `stray` (mm) and `lean` (rad).
struct Sweep {
    Stance from, to;
    double stray = 0, lean = 0;
};

// A question: how near is what is there to the head at `stance`?
struct Probe {
    Stance stance;
    std::uint32_t before = 1; // only solids born earlier
    double press = 0;         // mm: only what rises more than this above the plane through the tip across its axis
    double cutoff = 0;        // mm: only what is nearer
    // How far the head may be from `stance`: any point of it shifted by so much, the tip's plane sunk by so much (mm),
    // and the head turned about the tip by so much (rad).
    double shift = 0, sink = 0, turn = 0;
};

class Tree {
  public:
    explicit Tree(std::vector<Solid> solids);

    struct Hit {
        double distance = 0; // mm, negative inside a bead: down to minus its radius; the probe's cutoff if nothing
        Piece piece = Piece::nozzle;
        bool found = false;
    };
    // The least distance, of a head that stands as the probe says: shift, sink and turn are to be 0.
    [[nodiscard]] Hit nearest(const Shape& shape, const Probe& probe) const;

    // Whether anything may be nearer than the cutoff, however the head stands along the sweep, which keeps within the
    // probe's bounds: nothing; or only where points of the head move by at most `step` in all within these bounds; or
    // where they move farther.
    enum class Near : std::uint8_t { nothing, steady, moving };
    [[nodiscard]] Near any(const Shape& shape, const Probe& probe, const Sweep& sweep, double step) const;

    [[nodiscard]] bool empty() const { return solids_.empty(); }
    // No clearance is below minus this, mm: the greatest radius.
    [[nodiscard]] double deepest() const { return deepest_; }

  private:
    struct Node {
        Vec3 middle, half;          // of the box
        double ball = 0;            // no point of its solids is farther from the middle
        Vec3 normal;                // unit: about which they lie flat,
        double thick = 0, flat = 0; // within so much of the middle along it, and across it
        std::uint32_t born = 0;     // the first of its solids
        std::uint32_t first = 0;    // of a leaf its first solid, else its right child; the left one follows it
        std::uint32_t count = 0;    // of a leaf, how many solids; else 0
        [[nodiscard]] double reach(const Vec3& d) const;
    };
    class View;
    std::uint32_t build(std::uint32_t first, std::uint32_t last);
    [[nodiscard]] bool layered(const Node& node, std::uint32_t first, std::uint32_t last) const;
    void bound(Node& node, std::uint32_t first, std::uint32_t last) const;
    template <class Skip, class Meet>
    void visit(View& view, const double& cutoff, const Skip& skip, const Meet& meet) const;

    std::vector<Solid> solids_;
    std::vector<Node> nodes_;
    double deepest_ = 0;
};

// One solid per triangle, born at 0.
void add(const mesh::Mesh& mesh, std::vector<Solid>& to);

} // namespace filum::collision
