// Paths over and around printed material.
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

// Printed material as boxes: one for each stroke, which grows with it, and one for each leg of a connector.
struct PrintedBodies {
    struct Body {
        Box2 box;         // of the middle lines of its beads
        double top = 0;   // mm
        double half = 0;  // mm: half the width of its widest bead
        bool part = true; // false for connectors and strands
        bool strand = false;
    };
    std::vector<Body> bodies;

    void begin() { bodies.emplace_back(); } // begins a new stroke
    // Extends the newest body by beads with their middle lines in `lines`. The widest bead has `width` mm.
    void add(const Box2& lines, double width, double top);
    void connector(std::span<const Vec3> way, double width); // adds a body for each leg
    void strand(Vec3 a, Vec3 b, double width);               // adds a body that is in the way of the head only
    [[nodiscard]] Box2 bounds() const;                       // of the middle lines of the part, without connectors
    [[nodiscard]] double widest() const;                     // mm: the width of the widest bead
    // Whether the head would touch a body on the straight way from a to b.
    [[nodiscard]] bool hits(Vec3 a, Vec3 b, const machine::Head& head) const;
    // Whether the head would touch an earlier leg of this way, or its bead would cross one.
    [[nodiscard]] static bool meets_itself(std::span<const Vec3> way, double width, const machine::Head& head);
    // Whether a -> b comes within `margin` mm of the middle lines of a body that reaches above `z`. Strands do not
    // count, and with `own` the newest body does not.
    [[nodiscard]] bool blocks(Vec3 a, Vec3 b, double z, double margin, bool own) const;
};

// A path from `from` to `to` without extruding, of upright and level moves only. It runs level at the higher of both
// heights. It rises to the top of bodies that the nozzle's cone would touch, and over bodies under the carriage until
// the carriage clears them. It is never below `from` or `to` in between.
std::vector<Vec3> travel(const PrintedBodies& printed, Vec3 from, Vec3 to, const machine::Head& head);

// A path for a connector: straight out to `box` grown by `margin` mm, around it in the shorter direction, and straight
// in. The height changes evenly on the way around. Nothing if no straight way out (at from.z) or in (at to.z) satisfies
// `free(a, b)`. Nothing either if no way around is `clear`. Tie: the sides in the order left, right, front, back.
// (Sun et al. 2019, Fig. 8b; docs/algorithms/link3d.md#connectors-outside)
std::optional<std::vector<Vec3>> around(const Box2& box, double margin, Vec3 from, Vec3 to,
                                        const std::function<bool(Vec3, Vec3)>& free,
                                        const std::function<bool(std::span<const Vec3>)>& clear);

} // namespace filum::link3d
