#include "app/filum/slicer_text.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::app::filum {
namespace {

TEST(SlicerText, EverySettingOfAnyTextHasAName) {
    const char* const names[] = {"", " ", "\t", "=", "a", "B_2", "a b", "[a]"};
    for (const char* name : names)
        for (const Lines kind : {Lines::plain, Lines::commented}) {
            const std::string line = std::string(kind == Lines::commented ? "; " : "") + name + " = 3\n";
            for (const SlicerSetting& s : all_settings(line, kind)) EXPECT_FALSE(s.key.empty()) << line;
        }
}

TEST(SlicerText, JsonWithoutANameIsRefused) {
    EXPECT_EQ(json_settings(R"({"a": 3})").size(), 1U);
    for (const char* text : {R"({"": 3})", R"({"a": 3, "": [1, 2]})", R"({"": {}})"})
        EXPECT_THROW(json_settings(text), Error) << text;
}

} // namespace
} // namespace filum::app::filum
