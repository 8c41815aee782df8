#include "partition/names.hpp"
#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::partition {
namespace {

std::vector<surface::Sheet> named(const std::vector<std::string>& names) {
    std::vector<surface::Sheet> out(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) out[i].name = names[i];
    return out;
}

std::vector<std::string> names_of(const std::vector<surface::Sheet>& sheets) {
    std::vector<std::string> out;
    for (const auto& s : sheets) out.push_back(s.name);
    return out;
}

using Names = std::vector<std::string>;

TEST(Names, LettersGoOnBehindZ) {
    EXPECT_EQ(letters(0), "A");
    EXPECT_EQ(letters(25), "Z");
    EXPECT_EQ(letters(26), "AA");
    EXPECT_EQ(letters(27), "AB");
    EXPECT_EQ(letters(26 + 26 * 26), "AAA");
}

TEST(Names, NamesThatAreThereStayAndLettersSkipThem) {
    auto s = named({"", "A", "", "skin", ""});
    name(s, {"left"});
    EXPECT_EQ(names_of(s), (Names{"left", "A", "B", "skin", "C"}));
}

TEST(Names, TwoOfANameAreRefused) {
    auto twice = named({"A", "A"});
    EXPECT_THROW(name(twice, {}), Error);
    auto given = named({"A", ""});
    EXPECT_THROW(name(given, {"A"}), Error);
    auto many = named({""});
    EXPECT_THROW(name(many, {"x", "y"}), Error);
}

TEST(Names, OnlySomeAreKeptInTheirOrder) {
    auto s = named({"A", "B", "C"});
    keep_only(s, {"C", "A"});
    EXPECT_EQ(names_of(s), (Names{"A", "C"}));
    EXPECT_THROW(keep_only(s, {"B"}), Error);
}

TEST(Names, AListIsOfWords) {
    EXPECT_EQ(words("a,b.2", "only"), (Names{"a", "b.2"}));
    EXPECT_TRUE(words("", "only").empty());
    for (const char* bad : {",", "a,", ",a", "a b", "a/b"}) EXPECT_THROW(words(bad, "only"), Error) << bad;
}

} // namespace
} // namespace filum::partition
