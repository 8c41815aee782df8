#include "fill/volume.hpp"

#include "fill/fill.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::fill {

namespace {

using namespace test;

// Area under the beads, counted apart from the code under test.
double under(const toolpath::RegionPaths& paths) {
    double out = 0;
    for (const toolpath::Curve& c : paths.curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            if (j == 0 && !c.closed) continue;
            out += geom::distance(c.points[i], c.points[j]) * (c.width_at(i) + c.width_at(j)) / 2;
        }
    return out;
}

polygon::Region disc_region(double radius, int corners) {
    polygon::Region r;
    r.loops = disc({0, 0}, radius, corners);
    r.area = polygon::signed_area(r.loops);
    r.height = 0.2;
    return r;
}

} // namespace

TEST(Volume, BeadsOfARegionCoverItsArea) {
    for (const int corners : {3, 4, 5, 8, 64})
        for (const double radius : {2.0, 3.1, 4.0, 7.3}) {
            const polygon::Region r = disc_region(radius, corners);
            Notes notes;
            toolpath::RegionPaths paths = fill(r, {}, notes);
            const double before = under(paths) / r.area;
            notes.clear();
            make_exact(paths, notes);
            const double after = under(paths) / r.area;
            if (std::abs(before - 1) < kMostChange) {
                EXPECT_NEAR(after, 1, 1e-9) << corners << " corners, radius " << radius;
                EXPECT_TRUE(notes.empty());
            } else {
                ASSERT_EQ(notes.size(), 1U);
                EXPECT_NEAR(notes[0].amount, std::abs(1 - after) * r.area, 1e-9);
            }
        }
}

TEST(Volume, ChangesAreLimited) {
    polygon::Region r = disc_region(4, 64);
    Notes notes;
    toolpath::RegionPaths paths = fill(r, {}, notes);
    const double width = paths.curves[0].width_at(0);
    paths.area *= 2;
    notes.clear();
    make_exact(paths, notes);
    EXPECT_DOUBLE_EQ(paths.curves[0].width_at(0), width * (1 + kMostChange));
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::area_unreached);
}

} // namespace filum::fill
