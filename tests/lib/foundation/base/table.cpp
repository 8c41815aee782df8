#include "base/table.hpp"

#include <gtest/gtest.h>

namespace filum {
namespace {

using Rows = std::vector<std::vector<std::string_view>>;

TEST(Table, RowsHaveCellsBetweenTabs) {
    EXPECT_EQ(table_rows("# head\n\na\tb\t-\nc\t\td"), (Rows{{"a", "b", ""}, {"c", "", "d"}}));
    EXPECT_EQ(table_rows("one\n"), (Rows{{"one"}}));
    EXPECT_EQ(table_rows("\n#\n"), Rows{});
    EXPECT_EQ(table_rows(""), Rows{});
}

TEST(Table, CutLeavesTheRest) {
    std::string_view text = "a,b,";
    EXPECT_EQ(cut(text, ','), "a");
    EXPECT_EQ(cut(text, ','), "b");
    EXPECT_EQ(text, "");
    EXPECT_EQ(cut(text, ','), "");
}

} // namespace
} // namespace filum
