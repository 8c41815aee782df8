// A triangle mesh for local operations: splitting, collapsing and flipping sides.
#pragma once

#include "surface/surface.hpp"

#include <algorithm>
#include <array>

namespace filum::surface::fit {

enum class VertexKind : std::uint8_t {
    free,    // anywhere on the surface
    on_line, // on a rim or sharp edge that continues on both sides
    fixed
};

// A surface that is being changed. Removed vertices and triangles keep their numbers until compact(). The invariants
// of Surface hold after every operation.
struct Editable {
    std::vector<Vec3> at;            // mm, per vertex
    std::vector<double> size;        // mm, per vertex: intended length of sides
    std::vector<VertexKind> kind;    // per vertex
    std::vector<Vec3> up;            // per vertex: approximate normal, any length; 0 on sharp edges
    std::vector<Triangle> triangles; // three times kNone: removed
    std::vector<std::uint32_t> twin; // per half-edge
    std::vector<std::uint32_t> out;  // per vertex, as Surface::outgoing; kNone: removed
    std::vector<char> line;          // per half-edge: it is part of a rim or a sharp edge

    [[nodiscard]] std::uint32_t tail(std::uint32_t h) const { return triangles[h / 3][h % 3]; }
    [[nodiscard]] std::uint32_t head(std::uint32_t h) const { return tail(next(h)); }
    [[nodiscard]] std::uint32_t apex(std::uint32_t h) const { return tail(prev(h)); }
    [[nodiscard]] bool gone(std::uint32_t h) const { return triangles[h / 3][0] == kNone; }
    [[nodiscard]] double length(std::uint32_t h) const { return distance(at[tail(h)], at[head(h)]); }
    // Whether h is the half-edge of lower number of its edge; so each edge is visited once.
    [[nodiscard]] bool first(std::uint32_t h) const { return twin[h] == kNone || h < twin[h]; }
};

// Calls visit(h) for every half-edge that leaves the vertex, counter-clockwise.
template <class Visit>
void each_leaving(const Editable& m, std::uint32_t vertex, const Visit& visit) {
    each_of_fan(m.twin, m.out[vertex], visit);
}

using Corners = std::array<Vec3, 3>;
Corners corners(const Editable& m, const Triangle& t);

// Whether a triangle may be moved to `now`: it must face within 60 degrees of its corners' normals, except at sharp
// edges; if all corners are there, of `before`, a normal of any length. Its height must be at least a twentieth of its
// longest side, or the share `flatness` of it.
bool may_lie(const Editable& m, const Triangle& t, const Corners& now, const Vec3& before, double flatness);

Vec3 upright(const Corners& c);    // the normal with twice the area as its length
double flatness(const Corners& c); // height over longest side

// Inserts a vertex in the middle of side h and returns it. Its size is the mean of the ends' sizes.
std::uint32_t split(Editable& m, std::uint32_t h);

// Whether the tail of h can be merged into its head: no line or rim is lost, triangles may move, and no side becomes
// longer than `most(a, b)` mm for its ends a and b.
template <class Most>
bool collapsible(const Editable& m, std::uint32_t h, const Most& most);

// Collapses side h: its tail is merged into its head. Precondition: collapsible.
void collapse(Editable& m, std::uint32_t h);

// Whether the side h can be replaced by the other diagonal of its two triangles: it is not part of a line, and both
// new triangles are allowed.
bool flippable(const Editable& m, std::uint32_t h);
void flip(Editable& m, std::uint32_t h);

// Converts to a surface without the removed elements.
Surface compact(const Editable& m);

// Whether all triangles of a vertex may move with it to `to`, except those with the corner `but`.
bool may_move(const Editable& m, std::uint32_t vertex, const Vec3& to, std::uint32_t but = kNone);

// --- collapsible

bool joins_cleanly(const Editable& m, std::uint32_t h);

template <class Most>
bool collapsible(const Editable& m, std::uint32_t h, const Most& most) {
    const std::uint32_t a = m.tail(h), b = m.head(h);
    bool fits = m.kind[a] != VertexKind::fixed;
    each_leaving(m, a, [&](std::uint32_t k) {
        for (const std::uint32_t other : {m.head(k), m.apex(k)})
            fits = fits && (other == b || !(distance(m.at[other], m.at[b]) >
                                            std::max(most(other, b), distance(m.at[other], m.at[a]))));
    });
    return fits && joins_cleanly(m, h) && may_move(m, a, m.at[b], b);
}

} // namespace filum::surface::fit
