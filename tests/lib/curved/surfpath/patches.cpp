// Several patches, each with its plan.
#include "surfpath/patches.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::surfpath {
namespace {

surface::Sheet patch(const std::string& name, const std::string& algorithm, double x) {
    Notes notes;
    surface::Sheet out{surface::connect({{{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}, {{0, 1, 2}}}, notes), {}, {}};
    out.name = name;
    out.algorithm = algorithm;
    return out;
}

// A stroke along the patch's first side.
Plan side(const surface::Sheet& s) {
    Plan out;
    out.strokes.push_back({{{{{{0, s.surface.vertices[0]}, {0, s.surface.vertices[1]}}, false}, false}}});
    out.facts.push_back({"", "rows", 1, ""});
    out.notes.push_back({.code = NoteCode::area_bare, .amount = 1});
    return out;
}

TEST(Patches, FollowTheirOwnPlansUnlessOneIsNamed) {
    const std::vector<surface::Sheet> some{patch("A", "fina", 0), patch("", "", 3)};
    EXPECT_EQ(algorithms(some, {}), (Algorithms{Algorithm::fina, std::nullopt}));
    EXPECT_EQ(algorithms(some, Algorithm::fexa), (Algorithms{Algorithm::fexa, Algorithm::fexa}));
    const std::vector<surface::Sheet> none{patch("A", "", 0), patch("B", "", 3)};
    EXPECT_EQ(algorithms(none, {}), (Algorithms{Algorithm::geo_fiso, Algorithm::geo_fiso}));
    const std::vector<surface::Sheet> strange{patch("A", "fino", 0)};
    EXPECT_THROW(algorithms(strange, {}), Error);
    EXPECT_THROW((void)algorithms({}, {}), Error);
}

TEST(Patches, AreLaidOneAfterTheOther) {
    const std::vector<surface::Sheet> sheets{patch("A", "fina", 0), patch("", "", 3), patch("C", "fina", 6)};
    const auto by = algorithms(sheets, {});
    const auto patches = each_patch(sheets, by, 1, [&](std::size_t k) { return side(sheets[k]); });
    ASSERT_EQ(patches.facts.size(), 2);
    EXPECT_EQ(patches.facts[1].name, "patch.C.rows");
    ASSERT_EQ(patches.notes.size(), 3);
    EXPECT_EQ(patches.notes[0].code, NoteCode::area_bare);
    EXPECT_EQ(patches.notes[0].patch, "A");
    EXPECT_EQ(patches.notes[1].code, NoteCode::patch_unplanned);
    EXPECT_EQ(patches.notes[1].patch, "2");
    EXPECT_DOUBLE_EQ(patches.notes[1].amount, 0.5);
    EXPECT_EQ(patches.notes[1].x, 3);
    const auto all = spans(sheets, patches.plans, {});
    ASSERT_EQ(all.size(), 3);
    EXPECT_EQ(all[1].role, toolpath::Role::travel);
    EXPECT_EQ(all[1].points.front(), all[0].points.back());
    EXPECT_EQ(all[1].points.back(), all[2].points.front());
    EXPECT_EQ(all[2].stroke, 1);
    EXPECT_EQ(all[2].points.front(), (Vec3{6, 0, 0}));
}

TEST(Patches, OneIsAsItAlwaysWas) {
    const std::vector<surface::Sheet> one{patch("A", "fina", 0)};
    const auto patches = each_patch(one, algorithms(one, {}), 1, [&](std::size_t) { return side(one[0]); });
    EXPECT_EQ(patches.facts[0].name, "rows");
    EXPECT_EQ(patches.notes[0].code, NoteCode::area_bare);
    EXPECT_EQ(patches.notes[0].patch, "");
}

TEST(Patches, ErrorsNameThePatch) {
    const std::vector<surface::Sheet> two{patch("A", "fina", 0), patch("B", "fina", 3)};
    try {
        (void)each_patch(two, algorithms(two, {}), 1, [&](std::size_t k) {
            if (k == 1) throw Error(Exit::bad_input, "cannot lay it");
            return side(two[k]);
        });
        FAIL();
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "patch 'B': cannot lay it");
        EXPECT_EQ(e.exit(), Exit::bad_input);
    }
}

} // namespace
} // namespace filum::surfpath
