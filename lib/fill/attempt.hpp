// Closed curves made in several ways until they are sound.  Private to lib/fill.
#pragma once

#include "base/note.hpp"
#include "fill/cycle.hpp"
#include "toolpath/path.hpp"

#include <optional>
#include <span>
#include <utility>

namespace filum::fill {

struct Attempt {
    std::vector<toolpath::Curve> curves;
    std::size_t crossings = 0; // of the curves' segments
    Loops outermost;           // the rings along the outline
};

// The first attempt without crossings and, if `one` is asked for, of a single curve; else that of the fewest crossings,
// then curves (the first of those), none without curves if there is another.  Precondition: at least one setting.
template <class Setting, class Make>
Attempt best_attempt(std::span<const Setting> settings, bool one, Make&& make) {
    const auto faults = [](const Attempt& a) { return std::pair{a.crossings, a.curves.size()}; };
    std::optional<Attempt> best;
    for (const Setting& s : settings) {
        Attempt now = make(s);
        if (!best || (!now.curves.empty() && faults(now) < faults(*best))) best = std::move(now);
        if (best->crossings == 0 && (best->curves.size() == 1 || !one)) break;
    }
    return std::move(*best);
}

} // namespace filum::fill
