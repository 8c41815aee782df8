// Rings by arc length, and closed lines made of stretches of them.
#pragma once

#include "rings/rings.hpp"

namespace filum::rings {

// A bead: closed (its last point runs on to its first) or a stretch of one.
struct BeadLine {
    std::vector<Vec2> points;
    std::vector<double> width; // mm, per point
    std::vector<double> depth; // mm, per point: to the outline

    void add(Vec2 p, double w, double d) { points.push_back(p), width.push_back(w), depth.push_back(d); }
    [[nodiscard]] std::size_t size() const { return points.size(); }
};

// Where the points of rings lie along them.
struct RingLengths {
    std::vector<double> along;        // per point: mm from the ring's first point
    std::vector<double> length;       // per ring, mm
    std::vector<std::uint32_t> ring;  // per point
};
RingLengths lengths(const Rings& rings);

// Adds the points of a ring from s0 to s1 > s0 mm along it, both ends included; s is taken modulo its length.
void append(const Rings& rings, const RingLengths& lengths, std::uint32_t ring, double s0, double s1, BeadLine& to);

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
    BeadLine bead;
};

// Windows of different rings and the links that tie all their rims: the rings become one curve.
struct Splice {
    std::vector<Window> windows;
    std::vector<Link> links;
};

// The closed curves that the rings have become, the longest first; rings without windows as they were.  Windows of a
// ring do not overlap, and 0 <= s0 < its length.
std::vector<BeadLine> spliced(const Rings& rings, const RingLengths& lengths, const std::vector<Splice>& splices);

} // namespace filum::rings
