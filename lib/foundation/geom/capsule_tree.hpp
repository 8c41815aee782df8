// Consecutive segments in a tree of capsules: finds those near a point, in a box, or near those of another tree.
#pragma once

#include "geom/vec.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace filum::geom {

// All points within `radius` of the segment from-to; none if the radius is negative.
struct Capsule {
    Vec2 from, to;
    double radius = -1; // mm
};

// Lower bound on the distance between p and what the capsule holds, mm; infinite if it holds nothing.
double distance(const Capsule& c, Vec2 p);

// Whether no side of the box and no line along the capsule separates the two.
bool may_meet(const Capsule& c, const Box2& box);

// A packed binary tree: the children of node i are 2 i + 1 and 2 i + 2, and each leaf has a run of consecutive
// segments. These lie together on a curve, so no sorting is needed. A capsule lies along the mean direction of its
// segments, so it is narrow along a smooth outline, and around rows that go to and fro. Takes O(n) to build.
class CapsuleTree {
  public:
    using Segment = std::pair<Vec2, Vec2>;
    struct Run {
        std::size_t first, last; // segments [first, last)
    };

    CapsuleTree() : CapsuleTree(std::vector<Segment>{}) {}
    explicit CapsuleTree(const std::vector<Segment>& segments);

    void shift(Vec2 way);

    // The capsule around all segments below a node.
    [[nodiscard]] const Capsule& operator[](std::size_t node) const { return capsules_[node]; }
    [[nodiscard]] bool leaf(std::size_t node) const { return node + 1 >= leaves_; }
    [[nodiscard]] Run run(std::size_t leaf) const;

    // Calls bound = f(run) for every run whose capsule is at most the current bound away from p, near ones first in
    // general. The order depends on the segments only.
    template <class F>
    void near(Vec2 p, double bound, const F& f) const {
        if (distance(capsules_[0], p) <= bound) descend(0, p, bound, f);
    }

    // Calls f(run) for every run whose capsule may meet `box`, in ascending order, until f returns false.
    template <class F>
    void visit(const Box2& box, const F& f) const {
        std::size_t stack[64], depth = 0; // enough: each level adds one
        stack[depth++] = 0;
        while (depth > 0) {
            const std::size_t i = stack[--depth];
            if (!may_meet(capsules_[i], box)) continue;
            if (leaf(i)) {
                if (!f(run(i))) return;
                continue;
            }
            stack[depth++] = 2 * i + 2;
            stack[depth++] = 2 * i + 1;
        }
    }

  private:
    template <class F>
    void descend(std::size_t i, Vec2 p, double& bound, const F& f) const {
        if (leaf(i)) {
            bound = f(run(i));
            return;
        }
        std::size_t a = 2 * i + 1, b = a + 1;
        double da = distance(capsules_[a], p), db = distance(capsules_[b], p);
        if (db < da) {
            std::swap(a, b);
            std::swap(da, db);
        }
        if (da <= bound) descend(a, p, bound, f);
        if (db <= bound) descend(b, p, bound, f);
    }

    std::size_t segments_ = 0, leaves_ = 1; // leaves_ is a power of two
    std::vector<Capsule> capsules_;
};

} // namespace filum::geom
