// Rows: the lines of direction-parallel paths, ended where turns may take over.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/sheet.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// How far paths may go: up to a margin from the rims.
struct Inset {
    double margin = 0;                     // mm
    std::vector<Line> rings;               // where it is reached
    std::vector<std::vector<double>> ways; // per ring, as surface::curve::arc_lengths
    geodesic::ExactField field;            // from the rims, up to some margins

    // The distance of the nearest rim along the surface, mm; some multiple of the margin beyond that.
    [[nodiscard]] double room(const Surface& s, const Place& p) const;
};

// Where a row ends: on a ring of the inset; on none where the face is narrower than two margins.
struct RingPlace {
    std::uint32_t ring = surface::kNone;
    double way = 0; // mm along the ring
};

struct Row {
    Line line;            // threaded; open, or closed if it meets no rim
    double level = 0;     // mm: by which rows are ordered
    RingPlace begin, end; // of an open line
};

// Lines of one family that still run up to the rims.  All of them have what is less to the same side.
struct Raw {
    Line line;
    double level = 0;
};

// The isolines with levels times `sign`, 1 or -1, and turned round if that is -1.
void add(std::vector<Raw>& to, const std::vector<surface::Isoline>& isolines, double sign);

// Leaves out lines all of whose stretches lie on triangles that are marked; `marked` is per triangle, or empty.
void leave_out(std::vector<Raw>& lines, std::span<const char> marked);

struct Rows {
    std::vector<Row> rows; // by level, then as given
    Inset inset;
    double dropped = 0; // mm of rows that were too short
    std::uint64_t drops = 0;
    double longest_dropped = 0; // mm
    Vec3 dropped_at;            // the middle of that

    // Counts a row as one of them.
    void drop(const Line& row);
};

struct RowLimits {
    double margin = 0;   // mm: from every rim
    double shortest = 0; // mm: what is left of a line and shorter is dropped, unless all are
    double radius = 0;   // mm: what lines that were cut are eased to,
    double give = 0;     // mm: by so much at most
};

// The parts of `lines` that keep the margin, along the surface; exact.  Where a line comes nearer to a rim that it runs
// along, it follows the inset instead; closed ones stay closed by that where they can.  Where the face is too narrow
// for any place to keep the margin, lines in its middle stay.
Rows rows(const Surface& s, const std::vector<Raw>& lines, const RowLimits& limits);

} // namespace filum::surfpath::rows
