// Closed curves made in several ways until they are sound.  Private to lib/fill.
#pragma once

#include "toolpath/path.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace filum::fill {

struct Attempt {
    std::vector<toolpath::Curve> curves;
    std::size_t crossings = 0; // of the curves' segments
    double unplaced = 0;       // mm2 that no bead reaches
};

// What a bead's edges may be off at first, mm: ten micrometres, and no more than a fortieth of a bead.
inline double tolerance_for(double bead_width) { return std::min(0.01, bead_width / 40); }

// Of that: first the whole, and an eighth where the curve would cross itself.
inline constexpr double kShares[] = {1, 0.125};

// How rows of two beads are laid, from the best way to the last resort.
struct RowSetting {
    double share; // of the tolerance
    double row;   // height wanted, bead widths
};
inline constexpr RowSetting kRowSettings[] = {{kShares[0], 2}, {kShares[1], 2}, {kShares[1], 2.12}, {kShares[1], 1.9}};

// The first attempt without crossings and, if `one` is asked for, of a single curve; else that of the fewest crossings,
// then curves (the first of those), none without curves if there is another.
template <class Make>
Attempt best_rows(bool one, Make&& make) {
    const auto faults = [](const Attempt& a) { return std::pair{a.crossings, a.curves.size()}; };
    std::optional<Attempt> best;
    for (const RowSetting& s : kRowSettings) {
        Attempt now = make(s);
        if (!best || (!now.curves.empty() && faults(now) < faults(*best))) best = std::move(now);
        if (best->crossings == 0 && (best->curves.size() == 1 || !one)) break;
    }
    return std::move(*best);
}

} // namespace filum::fill
