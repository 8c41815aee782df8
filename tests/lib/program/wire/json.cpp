#include "wire/json.hpp"

#include <gtest/gtest.h>

namespace filum::wire {
namespace {

TEST(Json, ValuesAreText) {
    const auto v =
        json_values(R"({"a": "0.2", "b": ["225", "220"], "c": 1.5, "d": true, "e": [], "f": {"g": 1}, "h": null})");
    const std::map<std::string, std::string> expected{{"a", "0.2"}, {"b", "225,220"}, {"c", "1.5"}, {"d", "1"},
                                                      {"e", ""},    {"f", ""},        {"h", ""}};
    EXPECT_EQ(v, expected);
}

TEST(Json, WhatIsNoneHasNoValues) {
    for (const char* text : {"", "{", "[1, 2]", "\"a\"", "{\"a\": }", "PK\003\004"})
        EXPECT_TRUE(json_values(text).empty()) << text;
    const auto leaves = json_leaves(R"({"a": {"b": 1, "c": {"d": true}}, "e": [{"f": "x"}, "y"], "g": "z"})");
    EXPECT_EQ(leaves.at("a/b"), "1");
    EXPECT_EQ(leaves.at("a/c/d"), "1");
    EXPECT_EQ(leaves.at("e/0/f"), "x");
    EXPECT_EQ(leaves.at("e/1"), "y");
    EXPECT_EQ(leaves.at("g"), "z");
    EXPECT_TRUE(json_leaves(R"({"a": {"b": 1})").empty());
    EXPECT_EQ(json_values(R"({"a": 1, "a": 2})").at("a"), "2"); // presets of OrcaSlicer have such doubles
    EXPECT_EQ(json_values(R"({"a": ["x, y\n", "\"z\""]})").at("a"), R"("x, y\n";"\"z\"")");
    EXPECT_EQ(json_values(R"({"a": "\u00e9\ud83d\ude00\/"})").at("a"), "\xc3\xa9\xf0\x9f\x98\x80/");
    EXPECT_TRUE(json_values(std::string(100000, '[')).empty()); // no depth ends the program
}

} // namespace
} // namespace filum::wire
