// Turns between rows on the surface.
#pragma once

#include "surfpath/rows/rows.hpp"
#include "surfpath/rows/transit.hpp"

#include <algorithm>
#include <span>

namespace filum::surfpath::rows {

inline constexpr double kTightCosts = 20; // mm: least cost of a tight turn

struct TurnOptions {           // limits that are left out do not apply
    double spacing = 1;        // mm, between rows
    double least_radius = 2.4; // mm, of turns, where there is room
    double across = 1e300;     // mm: longest straight transit across other rows; the path is cut rather than go farther
    double along = 1e300;      // mm: longest transit along rims and other rows
    bool staggered = true;     // turns may lie at different depths; otherwise all are at the rim
    bool tight = false;        // turns of half a spacing cost no more than wide ones, as they waste less
};

// Options for turns of a least radius, which is at least half a spacing, as between neighbouring rows; or for hairpins,
// which all have that radius.
inline TurnOptions turn_options(double spacing, double least_radius, bool hairpins = false) {
    return {.spacing = spacing,
            .least_radius = hairpins ? spacing / 2 : std::max(least_radius, spacing / 2),
            .tight = hairpins};
}

// A turn or transit from one end of a row to another; ends are numbered as in plan/order.hpp.
struct SurfaceTurn {
    std::uint32_t from = 0, to = 0;
    double from_trim = 0, to_trim = 0; // mm of the rows that it replaces
    double radius = 0;                 // mm: its least radius; 0 for a rounded transit
    double cost = 0;                   // mm by which it lengthens the path, plus a penalty if it is tight
    Line line;                         // from `from` to `to`; empty for a way around a hole, which is computed later
    bool eased = false;                // it is a rounded transit rather than a turn
};

// Reverses the direction of a turn.
void reverse(SurfaceTurn& t);

class Turner {
  public:
    // The arguments must outlive the object.
    Turner(const Surface& s, const Rows& rows, const Transits& transits, const TurnOptions& o);

    // The turns worth considering, sorted by their ends, and the ways around holes that interrupt a line.
    [[nodiscard]] std::vector<SurfaceTurn> candidates() const;

    // The same turn at several depths behind the rim, the outermost first, `apart` mm from each other: to a depth of
    // two radii, where rows of the outermost turn are straight again, or of two lanes, so that hairpins find room
    // behind a transit along the rim. Wide turns stay wide.
    [[nodiscard]] std::vector<SurfaceTurn> deeper(const SurfaceTurn& turn, double apart) const;

    // The transit along `stretches` with its corners rounded; it may replace more of the rows than turns do.
    [[nodiscard]] SurfaceTurn eased(std::uint32_t from, const std::vector<Line>& stretches, std::uint32_t to) const;

    // The row from the end `in` to its other end, without the given lengths at both.
    [[nodiscard]] Line stretch(std::uint32_t in, double off_begin, double off_end) const;

    // The part of the row between two arc lengths from its end `in`.
    [[nodiscard]] Line part(std::uint32_t in, double from, double to) const;

  private:
    [[nodiscard]] const RingPlace& ring_place(std::uint32_t end) const;
    [[nodiscard]] const Line& inwards(std::uint32_t end) const;
    [[nodiscard]] std::span<const double> ways_inwards(std::uint32_t end) const;
    [[nodiscard]] double length(std::uint32_t row) const { return ways_[row].back(); }
    [[nodiscard]] Vec3 tangent(std::uint32_t end) const;
    [[nodiscard]] bool may_turn(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool same_line(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool leads_on(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] SurfaceTurn turn_between(std::uint32_t a, std::uint32_t b, double behind, bool bulbs = true) const;
    [[nodiscard]] double tightness(double radius) const;
    [[nodiscard]] double least_deeper(double radius) const;

    const Surface& surface_;
    const Rows& rows_;
    const Transits& transits_;
    TurnOptions o_;
    std::vector<Vec3> normals_;
    std::vector<Line> reversed_;
    std::vector<std::vector<double>> ways_, ways_reversed_;
};

} // namespace filum::surfpath::rows
