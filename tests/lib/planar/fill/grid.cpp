// Every pattern is laid on the grid of machines, and crosses nothing there but where a note tells it.
#include "toolpath/grid.hpp"
#include "fill/fill.hpp"
#include "pattern_check.hpp"

namespace filum::fill {
namespace {

using namespace test;

polygon::Region region_of(const Loops& loops) {
    polygon::Region r;
    r.loops = loops;
    r.area = polygon::signed_area(loops);
    r.height = 0.2;
    return r;
}

// How many crossings the notes tell of.
std::size_t told(const Notes& notes) {
    double sum = 0;
    for (const Note& n : notes) sum += n.code == NoteCode::curve_crosses_itself ? n.amount : 0;
    return static_cast<std::size_t>(sum);
}

void expect_on_grid(const Loops& loops, const Options& o, const std::string& name) {
    Notes notes;
    const auto paths = fill(region_of(loops), o, notes);
    for (const Curve& c : paths.curves)
        for (const Vec2 p : c.points) ASSERT_EQ(p, toolpath::on_grid(p)) << name;
    EXPECT_EQ(crossings(paths.curves), told(notes)) << name;
}

TEST(OnGrid, EveryPattern) {
    for (std::size_t k = 0; k < kPatternNames.size(); ++k)
        for (unsigned seed = 0; seed < 8; ++seed)
            for (const Loops& loops : random_regions(seed)) {
                Options o;
                o.pattern = static_cast<Pattern>(k);
                if (o.pattern != Pattern::spiral && o.pattern != Pattern::contour) o.angles_deg = {37};
                expect_on_grid(loops, o, kPatternNames[k] + std::to_string(seed));
            }
}

TEST(OnGrid, RingsOfScaffoldsAndThinWalls) {
    Options ringed, thin;
    ringed.pattern = Pattern::scaffold;
    ringed.rings = 2;
    thin.bead_width = 0.7;
    thin.min_width = 0.35;
    for (unsigned seed = 0; seed < 8; ++seed)
        for (const Loops& loops : random_regions(seed)) {
            expect_on_grid(loops, ringed, "rings " + std::to_string(seed));
            for (const Thin how : {Thin::single, Thin::half_height}) {
                thin.thin = how;
                expect_on_grid(loops, thin, kThinNames[static_cast<std::size_t>(how)] + std::to_string(seed));
            }
        }
}

} // namespace
} // namespace filum::fill
