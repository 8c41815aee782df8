#include "laminate/stack.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::laminate {
namespace {

std::vector<double> angles(const std::vector<Ply>& plies) {
    std::vector<double> out;
    for (const Ply& p : plies) out.push_back(p.angle);
    return out;
}

TEST(Stack, IsMirrored) {
    EXPECT_EQ(angles(plies_of("0,45,-45,90", {}, true)), (std::vector<double>{0, 45, -45, 90, 90, -45, 45, 0}));
    EXPECT_EQ(plies_of("0,90", {}, true).size(), 4U);
    EXPECT_THROW(plies_of("", {}, false), Error);
    EXPECT_THROW(plies_of("0,,90", {}, false), Error);
    EXPECT_THROW(plies_of("0,x", {}, false), Error);
    EXPECT_THROW(plies_of("0,361", {}, false), Error);
}

TEST(Stack, ComesFromATable) {
    const auto plies = plies_of_table("# a tube\nangle\tspacing side tool\n0 1 over 0\n\n45 1.5 under 1 # inside\n",
                                      "x", Ply{.height = 0.3}, false);
    ASSERT_EQ(plies.size(), 2U);
    EXPECT_FALSE(plies[0].under);
    EXPECT_TRUE(plies[1].under);
    EXPECT_EQ(plies[1].spacing, 1.5);
    EXPECT_EQ(plies[1].tool, 1U);
    EXPECT_EQ(plies[1].height, 0.3);
}

TEST(Stack, WrongTablesAreRefusedWithTheirLine) {
    for (const auto& [text, says] : {std::pair{"angel\n0\n", "line 1: unknown column 'angel'"},
                                     {"angle tool\n0\n", "line 2: it has 1 words"},
                                     {"angle\n0\nx\n", "line 3"},
                                     {"angle side\n0 left\n", "line 2: a side must be"},
                                     {"angle tool\n0 1.5\n", "line 2: a tool must be"},
                                     {"angle spacing\n0 0\n", "line 2: spacing 0"},
                                     {"angle\n", "contains no ply"}}) {
        try {
            plies_of_table(text, "x", {}, false);
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
            EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
        }
    }
}

TEST(Stack, SymmetryCountsPliesWithoutTheirLike) {
    EXPECT_EQ(symmetry(plies_of("0,45,-45,90", {}, true)).unlike, 0U);
    EXPECT_EQ(symmetry(plies_of("0,45,-45,0", {}, false)).unlike, 2U);
    EXPECT_EQ(symmetry(plies_of("0,45,-45,0", {}, false)).unequal, 0U);
    EXPECT_EQ(symmetry(plies_of("0,180,360", {}, false)).unlike, 0U); // half a turn is none
    EXPECT_EQ(symmetry(plies_of("45,-45,45", {}, false)).unequal, 1U);
    EXPECT_EQ(symmetry(plies_of("30,-30,150,90", {}, false)).unequal, 1U);
    auto plies = plies_of("0,90,0", {}, false);
    plies[2].height *= 2;
    EXPECT_EQ(symmetry(plies).unlike, 2U);
    EXPECT_EQ(symmetry(plies).first, 0U);
}

TEST(Stack, PliesUnderTheSurfaceLieBelowThoseOverIt) {
    auto plies = plies_of("0,90,90,0", {}, false);
    plies[2].under = plies[3].under = true;
    EXPECT_EQ(through(plies), (std::vector<std::size_t>{3, 2, 0, 1}));
    EXPECT_EQ(symmetry(plies).unlike, 4U); // 0 90 | 0 90: what lies under was laid outwards from the surface
}

} // namespace
} // namespace filum::laminate
