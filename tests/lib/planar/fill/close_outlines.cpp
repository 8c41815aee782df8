#include "../../close_outlines.hpp"
#include "fill/fill.hpp"
#include "pattern_check.hpp"

namespace filum::fill {
namespace {

// A bead of a fifteenth of the region's width: some rings in most of them.
double bead_for(const test::Loops& region) {
    const auto box = polygon::bounds(region);
    return std::clamp(std::max(box.hi.x - box.lo.x, box.hi.y - box.lo.y) / 15, 0.05, 20.0);
}

void expect_filled(const test::Loops& loops) {
    polygon::Region region;
    region.loops = loops;
    Options options;
    options.bead_width = bead_for(loops);
    Notes notes;
    const toolpath::RegionPaths paths = fill(region, options, notes);
    bool reported = false; // that something crosses, or was left out
    for (const Note& n : notes)
        reported = reported || n.code == NoteCode::curve_crosses_itself || n.code == NoteCode::ring_unjoined;
    if (!reported) {
        EXPECT_LE(paths.curves.size(), 1U);
        EXPECT_EQ(test::crossings(paths.curves), 0U);
    }
    for (const toolpath::Curve& c : paths.curves)
        for (const geom::Vec2 p : c.points) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

TEST(Fill, FillsOutlinesThatNearlyTouchThemselves) {
    const unsigned first = test::first_outline();
    for (unsigned seed = first; seed < first + test::outlines(100); ++seed) {
        SCOPED_TRACE(seed);
        for (const test::Loops& region : test::CloseOutlines(seed).regions()) {
            try {
                expect_filled(region);
            } catch (const std::exception& e) {
                ADD_FAILURE() << e.what();
            }
        }
    }
}

} // namespace
} // namespace filum::fill
