// Triangles that change one after the other: sides are halved, shortened to a point, flipped.
#pragma once

#include "surface/surface.hpp"

#include <algorithm>
#include <array>

namespace filum::surface::fit {

enum class Kind : std::uint8_t {
    free,    // anywhere on the surface
    on_line, // on a rim or a sharp edge, which goes on to both sides
    fixed
};

// A surface under change.  Vertices and triangles that are gone keep their numbers until compact().  What Surface
// promises of sides, fans and facing holds after each change.
struct Editable {
    std::vector<Vec3> at;            // mm, per vertex
    std::vector<double> size;        // mm, per vertex: how long sides there shall be
    std::vector<Kind> kind;          // per vertex
    std::vector<Vec3> up;            // per vertex: about where the surface faces, any length; 0 on sharp edges
    std::vector<Triangle> triangles; // kNone thrice: gone
    std::vector<std::uint32_t> twin; // per half-edge
    std::vector<std::uint32_t> out;  // per vertex, as Surface::outgoing; kNone: gone
    std::vector<char> line;          // per half-edge: it is part of a rim or a sharp edge

    [[nodiscard]] std::uint32_t tail(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    [[nodiscard]] std::uint32_t head(std::uint32_t h) const { return tail(next(h)); }
    [[nodiscard]] std::uint32_t apex(std::uint32_t h) const { return tail(prev(h)); }
    [[nodiscard]] bool gone(std::uint32_t h) const { return triangles[h / 3][0] == kNone; }
    [[nodiscard]] double length(std::uint32_t h) const { return distance(at[tail(h)], at[head(h)]); }
    // Half-edge h or its twin, whichever is less: so each side comes once.
    [[nodiscard]] bool first(std::uint32_t h) const { return twin[h] == kNone || h < twin[h]; }
};

// Calls visit(h) for every half-edge that leaves the vertex, counter-clockwise.
template <class Visit>
void each_leaving(const Editable& m, std::uint32_t vertex, const Visit& visit) {
    each_of_fan(m.twin, m.out[vertex], visit);
}

using Corners = std::array<Vec3, 3>;
Corners corners(const Editable& m, const Triangle& t);

// Whether a triangle may come to lie at `now`: it faces as those of its corners do that are not on sharp edges, or, if
// all are, as `before` does, which is any length along a normal, by 60 degrees; and its height is a twentieth of its
// longest side, or at least not less of it than `flatness`.
bool may_lie(const Editable& m, const Triangle& t, const Corners& now, const Vec3& before, double flatness);

Vec3 upright(const Corners& c);    // the normal, by twice the area
double flatness(const Corners& c); // the height over the longest side

// Puts a vertex into the middle of side h; returns it.  Its size is the mean of the ends'.
std::uint32_t split(Editable& m, std::uint32_t h);

// Whether the tail of h may go into its head: neither a line nor a rim is lost by it, triangles may lie as they come
// to, no side gets longer than `most(a, b)` mm, a and b its ends.
template <class Most>
bool collapsible(const Editable& m, std::uint32_t h, const Most& most);

// Takes the side h out: its tail goes into its head.  Precondition: collapsible.
void collapse(Editable& m, std::uint32_t h);

// Whether the other diagonal of the two triangles at h may take its place: no line, both new triangles may lie so.
bool flippable(const Editable& m, std::uint32_t h);
void flip(Editable& m, std::uint32_t h);

// As a surface; what is gone is left out.
Surface compact(const Editable& m);

// Whether all triangles of a vertex may lie as they do when it is moved; but those that have `but` for a corner.
bool may_move(const Editable& m, std::uint32_t vertex, const Vec3& to, std::uint32_t but = kNone);

// --- collapsible

bool joins_cleanly(const Editable& m, std::uint32_t h);

template <class Most>
bool collapsible(const Editable& m, std::uint32_t h, const Most& most) {
    const std::uint32_t a = m.tail(h), b = m.head(h);
    bool fits = m.kind[a] != Kind::fixed;
    each_leaving(m, a, [&](std::uint32_t k) {
        for (const std::uint32_t other : {m.head(k), m.apex(k)})
            fits = fits && (other == b || !(distance(m.at[other], m.at[b]) >
                                            std::max(most(other, b), distance(m.at[other], m.at[a]))));
    });
    return fits && joins_cleanly(m, h) && may_move(m, a, m.at[b], b);
}

} // namespace filum::surface::fit
