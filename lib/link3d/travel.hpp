// Ways over and around what is printed.
#pragma once

#include "geom/vec.hpp"
#include "machine/head.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace filum::link3d {

using geom::Box2;
using geom::Vec2;
using geom::Vec3;

// What is printed, as boxes: one per stroke, that grows with it.
struct Printed {
    struct Body {
        Box2 box;
        double top = 0;   // mm
        bool part = true; // not a connector
    };
    std::vector<Body> bodies;

    void begin() { bodies.emplace_back(); }    // a new stroke
    void add(const Box2& box, double top);     // to the newest
    void connector(std::span<const Vec3> way); // a body for each of its legs
    [[nodiscard]] Box2 bounds() const;         // of the part
    // True if the head would touch a body on the straight way from a to b.
    [[nodiscard]] bool hits(Vec3 a, Vec3 b, const machine::Head& head) const;
    // True if a -> b comes within `margin` mm of a body that reaches above `z`; the newest counts only if not `own`.
    [[nodiscard]] bool blocks(Vec3 a, Vec3 b, double z, double margin, bool own) const;
};

// A way from `from` to `to` without extruding: level at the higher of both, but over whatever the head would meet on
// the way: bodies that the nozzle's cone would touch are passed at their top, and those under the carriage so that it
// clears them.  Only upright and level moves; never below `from` or `to` in between.
std::vector<Vec3> travel(const Printed& printed, Vec3 from, Vec3 to, const machine::Head& head);

// A way for a connector: straight out to `box` grown by `margin` mm, around it the shorter way, and straight in; the
// height changes evenly on the way around.  Nothing if there is no straight way out (at from.z) or in (at to.z) for
// which `free(a, b)` holds, or no way around of which each leg is `clear`.  Tie: the sides in the order left, right,
// front, back. (Sun et al. 2019, Fig. 8b; docs/algorithms/link3d.md#connectors-outside)
std::optional<std::vector<Vec3>> around(const Box2& box, double margin, Vec3 from, Vec3 to,
                                        const std::function<bool(Vec3, Vec3)>& free,
                                        const std::function<bool(Vec3, Vec3)>& clear);

} // namespace filum::link3d
