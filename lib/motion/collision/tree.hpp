// The obstacles of a head in a tree of boxes with their times of birth.
#pragma once

#include "collision/shape.hpp"
#include "mesh/mesh.hpp"

#include <cstdint>
#include <vector>

namespace filum::collision {

// All points nearer than `radius` to the convex hull of the corners: a triangle of a mesh (its last corner twice,
// radius 0) or a bead.
struct Solid {
    std::array<Vec3, 4> corner; // in order around it
    double radius = 0;          // mm
    std::uint32_t born = 0;     // present for probes with a greater `before`
};

// The bead of `width` and `height` (mm) from stance `from` to `to`, whose tips are on the middle of its top: the hull
// of two rods of half its height along its sides. A bead narrower than high counts as broad as it is high.
Solid bead(const ToolFrame& from, const ToolFrame& to, double width, double height, std::uint32_t born);

// The motion of a head during a query: from one stance to another at even speed, the axis rotating evenly, with a
// deviation of at most `stray` (mm) and `lean` (rad).
struct Sweep {
    ToolFrame from, to;
    double stray = 0, lean = 0;
};

// A query for the distance of obstacles from the head at `stance`.
struct Probe {
    ToolFrame stance;
    std::uint32_t before = 1; // only solids born earlier
    double press = 0;         // mm: only what rises more than this above the plane through the tip across its axis
    double cutoff = 0;        // mm: only what is nearer
    // How far the head may be from `stance`: any point displaced by `shift`, the tip's plane lowered by `sink` (mm),
    // and the head rotated about the tip by `turn` (rad).
    double shift = 0, sink = 0, turn = 0;
};

class Tree {
  public:
    explicit Tree(std::vector<Solid> solids);

    struct Hit {
        // mm, negative inside a bead, down to minus its radius; the probe's cutoff if nothing is nearer
        double distance = 0;
        HeadPiece piece = HeadPiece::nozzle;
        bool found = false;
    };
    // The least distance from a head exactly at the probe's stance; shift, sink and turn must be 0.
    [[nodiscard]] Hit nearest(const Shape& shape, const Probe& probe) const;

    // Whether anything may come nearer than the cutoff during the sweep, which stays within the probe's bounds:
    // nothing; only solids near which points of the head move by at most `step` in total (steady); or solids near
    // which they move farther (moving).
    enum class Proximity : std::uint8_t { nothing, steady, moving };
    [[nodiscard]] Proximity any(const Shape& shape, const Probe& probe, const Sweep& sweep, double step) const;

    [[nodiscard]] bool empty() const { return solids_.empty(); }
    // No clearance is less than minus this, mm: the greatest radius.
    [[nodiscard]] double deepest() const { return deepest_; }

  private:
    struct Node {
        Vec3 middle, half;          // of the box
        double ball = 0;            // no point of its solids is farther from the middle
        Vec3 normal;                // unit: normal of a flat node
        double thick = 0, flat = 0; // extent from the middle along the normal, and across it
        std::uint32_t born = 0;     // the earliest birth of its solids
        std::uint32_t first = 0;    // leaf: its first solid; otherwise its right child, the left one follows it
        std::uint32_t count = 0;    // leaf: number of solids; otherwise 0
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

// Adds one solid per triangle, born at 0.
void add(const mesh::Mesh& mesh, std::vector<Solid>& to);

} // namespace filum::collision
