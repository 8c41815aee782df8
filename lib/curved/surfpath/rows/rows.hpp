// Rows: lines side by side, clipped where turns between them begin.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// The lines at a margin from the rims, beyond which paths must not go.
struct Inset {
    double margin = 0;                     // mm
    double half = 0;                       // mm: half a spacing; equal to the margin without beads along the rims
    std::vector<Line> rings;               // lines at that distance from the rims
    std::vector<std::vector<double>> ways; // arc lengths of the points of each ring
    geodesic::ExactField field;            // distance from the rims, up to a few margins

    // Distance from the nearest rim along the surface, mm; a multiple of the margin if it is farther.
    [[nodiscard]] double room(const Surface& s, const Place& p) const;
};

// Where a row ends on a ring of the inset; kNone where the surface is narrower than two margins.
struct RingPlace {
    std::uint32_t ring = surface::kNone;
    double way = 0; // mm along the ring
};

struct Row {
    Line line;            // threaded; open, or closed if it meets no rim
    double level = 0;     // mm: rows are sorted by it
    RingPlace begin, end; // of an open line
};

// A line of a family before it is clipped at the rims. On all lines of a family the smaller levels are on the same
// side.
struct UnclippedLine {
    Line line;
    double level = 0;
};

// Appends the isolines with levels multiplied by `sign`, 1 or -1; they are reversed for -1.
void add(std::vector<UnclippedLine>& to, const std::vector<surface::Isoline>& isolines, double sign);

// Removes lines that lie entirely on marked triangles. `marked` is per triangle, or empty.
void leave_out(std::vector<UnclippedLine>& lines, std::span<const char> marked);

struct Rows {
    std::vector<Row> rows; // by level, then in the order given
    Inset inset;
    double dropped = 0; // mm of rows that were too short
    std::uint64_t drops = 0;
    double longest_dropped = 0; // mm
    Vec3 dropped_at;            // its middle

    // Counts a row as dropped.
    void drop(const Line& row);
};

struct RowLimits {
    double margin = 0;      // mm: distance from every rim, half a spacing
    double shortest = 0;    // mm: shorter remainders of lines are dropped, unless all are
    double radius = 0;      // mm: radius to which clipped lines are eased
    double give = 0;        // mm: by which easing may move them
    unsigned rim_beads = 0; // closed beads along every rim; rows end that much farther inside
    double rim_bead = 0;    // mm: width of each of them
};

// Clips `lines` to the places that keep the margin, measured exactly along the surface. A line that comes nearer to a
// rim along which it runs follows the inset there; closed lines stay closed where possible. Lines in the middle of
// parts that are too narrow for the margin are kept. With `rim_beads`, the rows include these closed lines.
Rows rows(const Surface& s, const std::vector<UnclippedLine>& lines, const RowLimits& limits);

} // namespace filum::surfpath::rows
