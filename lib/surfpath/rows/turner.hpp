// Turns between rows, laid on the surface.
#pragma once

#include "surfpath/rows/rows.hpp"
#include "surfpath/rows/transit.hpp"

#include <algorithm>
#include <span>

namespace filum::surfpath::rows {

inline constexpr double kTight = 20; // mm: what a tight turn costs at least

struct Turning {               // what is left out has no limit
    double spacing = 1;        // mm, between rows
    double least_radius = 2.4; // mm, of turns, where there is room
    double across = 1e300;     // mm: of ways straight over other rows, at most; rather than longer ones a cut
    double along = 1e300;      // mm: likewise, of ways along rims and other rows
    bool staggered = true;     // turns lie behind each other; else all at the rim
    bool tight = false;        // turns within half a spacing cost no more than wide ones, as they waste less
};

// Turns are never tighter than those between neighbouring rows.
inline Turning turning(double spacing, double least_radius) {
    return {.spacing = spacing, .least_radius = std::max(least_radius, spacing / 2)};
}

// From one end of a row to that of another; ends are numbered as in order.hpp.
struct LaidTurn {
    std::uint32_t from = 0, to = 0;
    double from_trim = 0, to_trim = 0; // mm: what it replaces of the rows
    double radius = 0;                 // mm, the least
    double cost = 0;                   // mm: what it adds to the path, and more for what is tight
    Line line;                         // from `from` to `to`; none yet for a way round a hole
    bool eased = false;                // a way along rims or across, no turn
};

// The same the other way round.
void turn_round(LaidTurn& t);

class Turner {
  public:
    // All must outlive it.
    Turner(const Surface& s, const Rows& rows, const Transits& transits, const Turning& o);

    // The turns worth considering, by their ends; ways round holes among them, which join what is one line.
    [[nodiscard]] std::vector<LaidTurn> turns() const;

    // The same turn at several depths behind the rim, the outermost first, `apart` mm from each other, as far as it
    // stays as wide: down to two radii, where the rows of the outermost no longer turn.
    [[nodiscard]] std::vector<LaidTurn> deeper(const LaidTurn& turn, double apart) const;

    // The way over `stretches` with its corners rounded; trims more than turns do.
    [[nodiscard]] LaidTurn eased(std::uint32_t from, const std::vector<Line>& stretches, std::uint32_t to) const;

    // The row from the end `in` to its other end, with these lengths cut off.
    [[nodiscard]] Line stretch(std::uint32_t in, double off_begin, double off_end) const;

    // The row from the end `in` inwards, from one way to another.
    [[nodiscard]] Line part(std::uint32_t in, double from, double to) const;

  private:
    [[nodiscard]] const RingPlace& ring_place(std::uint32_t end) const;
    [[nodiscard]] const Line& inwards(std::uint32_t end) const;
    [[nodiscard]] std::span<const double> ways_inwards(std::uint32_t end) const;
    [[nodiscard]] double length(std::uint32_t row) const { return ways_[row].back(); }
    [[nodiscard]] Vec3 tangent(std::uint32_t end) const;
    [[nodiscard]] bool near(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool same_line(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool leads_on(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] LaidTurn lay(std::uint32_t a, std::uint32_t b, double behind, bool bulbs = true) const;
    [[nodiscard]] double tightness(double radius) const;
    [[nodiscard]] std::vector<double> turning(const Line& line, std::span<const double> ways) const;

    const Surface& surface_;
    const Rows& rows_;
    const Transits& transits_;
    Turning o_;
    std::vector<Vec3> normals_;
    std::vector<Line> reversed_;
    std::vector<std::vector<double>> ways_, ways_reversed_;
};

} // namespace filum::surfpath::rows
