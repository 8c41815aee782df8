#include "cli/headings.hpp"

#include "cli/document.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace filum::cli {
namespace {

struct Grouped {
    bool plain = false, strands = false, pores = false, rows = false;
};

Spec grouped(Grouped& o, std::vector<Group> groups) {
    Spec out;
    out.name = "stage";
    out.options = {Option{"pores", &o.pores, "", "of strands"}.when("pattern=lattice strands"),
                   Option{"plain", &o.plain, "", "of all"},
                   Option{"strands", &o.strands, "", "too"}.when("pattern=lattice !rows"),
                   Option{"rows", &o.rows, "", "alone"}.when("plain")};
    out.groups = std::move(groups);
    return out;
}

TEST(Sections, FollowTheGroupsAndTellOnceWhatAllNeed) {
    Grouped o;
    const auto all = sections(grouped(o, {{"lattice", {"strands", "pores"}}, {"rows", {"rows"}}}), {});
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(heading_text(all[0]), "options");
    EXPECT_EQ(all[0].options.front().name, "plain");
    EXPECT_EQ(heading_text(all[1]), "lattice (with --pattern lattice)");
    EXPECT_EQ(all[1].options[0].needs, "!rows");
    EXPECT_EQ(all[1].options[1].needs, "strands");
    EXPECT_EQ(heading_text(all[2]), "rows"); // one alone keeps what it needs
    EXPECT_EQ(all[2].options[0].needs, "plain");
    EXPECT_EQ(all[3].heading, "every command");
}

TEST(Sections, RefuseGroupsOfWhatThereIsNot) {
    Grouped o;
    EXPECT_THROW(sections(grouped(o, {{"rows", {"row"}}}), {}), std::logic_error);
    EXPECT_THROW(sections(grouped(o, {{"rows", {"rows"}}, {"more", {"rows"}}}), {}), std::logic_error);
}

TEST(Sections, HelpShowsThem) {
    Grouped o;
    const auto text = help(grouped(o, {{"lattice", {"strands", "pores"}}}));
    EXPECT_NE(text.find("\nlattice (with --pattern lattice):\n  --strands "), std::string::npos) << text;
    EXPECT_NE(markdown(grouped(o, {{"lattice", {"strands"}}})).find("### Lattice\n"), std::string::npos);
}

} // namespace
} // namespace filum::cli
