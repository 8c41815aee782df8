// Random regions for tests of hollow parts, and what must hold of every fill.
#pragma once

#include "../../../trials.hpp"
#include "../../fill/pattern_check.hpp"
#include "fill/hollow/hollow.hpp"
#include "fill/join/crossings.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace filum::fill::hollow {

inline constexpr double kBead = 0.4; // mm

struct Case {
    polygon::Region region;
    unsigned seed;
};

// The area of a region without its sparse areas.
inline polygon::Loops solid_part(const polygon::Region& region) {
    polygon::Loops out = region.loops;
    for (const auto& a : region.areas)
        if (a.kind == polygon::AreaKind::sparse) out = polygon::subtract(out, a.loops);
    return out;
}

// Regions of many shapes, with one wall and no areas.
inline std::vector<Case> random_cases(unsigned seeds) {
    std::vector<Case> out;
    for (unsigned seed = 0, n = trials(static_cast<int>(seeds)); seed < n; ++seed)
        for (polygon::Loops loops : test::random_regions(seed)) {
            for (auto& p : loops.points) p = 2.0 * p;
            polygon::Region r;
            r.layer = seed;
            r.z = 0.2 * seed + 0.2;
            r.height = 0.2;
            r.walls = 1;
            r.area = polygon::signed_area(loops);
            r.loops = std::move(loops);
            out.push_back({std::move(r), seed});
        }
    return out;
}

// Closed curves that do not cross themselves, inside the region; more than one only with a note.  Returns how many.
inline std::size_t sound_curves(const Case& c) {
    Notes notes;
    const auto paths = fill(c.region, {.bead_width = kBead}, notes);
    EXPECT_FALSE(paths.curves.empty()) << c.seed;
    for (const auto& curve : paths.curves) EXPECT_TRUE(curve.closed);
    EXPECT_EQ(fill::join::crossing_pairs(paths.curves, kBead).size(), 0U) << c.seed;
    EXPECT_EQ(paths.curves.size() > 1, !notes.empty() && notes.back().code == NoteCode::ring_unjoined) << c.seed;
    // acute tips may be moved a little
    EXPECT_LT(test::farthest_outside(c.region.loops, paths.curves), 0.12) << c.seed;
    return paths.curves.size();
}

} // namespace filum::fill::hollow
