// Pairs of segments that cross properly, looked for by nothing but their boxes: a judge of its own beside lib's grids.
#pragma once

#include "geom/segment_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace filum::test {

// How many pairs cross; those that share an end do not.
inline std::size_t crossing_pairs_of(std::vector<geom::Segment> all) {
    const auto low = [](const geom::Segment& s) { return std::min(s.a.x, s.b.x); };
    std::ranges::sort(all, {}, low);
    std::size_t out = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const geom::Segment& s = all[i];
        const double high = std::max(s.a.x, s.b.x);
        for (std::size_t j = i + 1; j < all.size() && low(all[j]) <= high; ++j)
            out += geom::cross_properly(s.a, s.b, all[j].a, all[j].b) ? 1 : 0;
    }
    return out;
}

} // namespace filum::test
