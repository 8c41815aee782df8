// The regular expressions of macros: their syntax is kept, whichever library is behind them.
#include "macro/regex.hpp"

#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <string>

namespace {

using filum::macro::Regex;

TEST(Regex, TableOfConstructs) {
    const std::tuple<const char*, const char*, bool> kTable[] = {{"abc", "abc", true},
                                                                 {"abc", "abcd", false},
                                                                 {"a.c", "a\nc", true},
                                                                 {".*X.*", "a\nX\nb", true},
                                                                 {"a|b|cd", "cd", true},
                                                                 {"(a|b)*", "abba", true},
                                                                 {"(?:ab)+", "abab", true},
                                                                 {"(ab)+", "aba", false},
                                                                 {"a{2,3}", "aa", true},
                                                                 {"a{2,3}", "aaaa", false},
                                                                 {"a{2,}", "aaaaa", true},
                                                                 {"a{0}b", "b", true},
                                                                 {"[a-c]+", "abc", true},
                                                                 {"[^a-c]+", "abd", false},
                                                                 {"[]a]+", "]a", true},
                                                                 {"[a\\-z]", "-", true},
                                                                 {"\\d+\\.\\d", "10.5", true},
                                                                 {"\\w+\\s\\W", "ab !", true},
                                                                 {"\\bfoo\\b.*", "foo bar", true},
                                                                 {"^a$", "a", true},
                                                                 {"a{", "a{", true}, // as Perl and Boost read it
                                                                 {"a*?b", "aab", true},
                                                                 {"", "", true},
                                                                 {"(a*)*b", "aaaa", false},
                                                                 {"x|", "", true}};
    for (const auto& [pattern, text, wanted] : kTable) EXPECT_EQ(Regex(pattern).matches(text), wanted) << pattern;
    for (const char* wrong : {"(", ")", "[", "*a", "a{2,1}", "(?=a)", "(a)\\1", "\\", "a{99999}", "[b-a]"})
        EXPECT_THROW(Regex{wrong}, std::invalid_argument) << wrong;
}

TEST(Regex, HostilePatternsTakeNoTime) {
    EXPECT_FALSE(Regex("(a*)*b").matches(std::string(20000, 'a')));
    EXPECT_FALSE(Regex("(a|aa)+b").matches(std::string(20000, 'a')));
    EXPECT_THROW(Regex("((((a{1000}){1000}){1000}){1000})"), std::invalid_argument);
    EXPECT_THROW(Regex(std::string(1000, '(')), std::invalid_argument);
}

// Random patterns of what both know.
TEST(Regex, AgreesWithTheStandardLibrary) {
    std::mt19937 random(3);
    const char* kAtoms[] = {"a", "b", "[ab]", "[^a]", "(a|b)", "(ab)", "(a|)", "(?:ba|b)", "\\w"};
    const char* kRepeats[] = {"", "", "", "*", "+", "?", "{2}", "{1,2}"};
    for (int i = 0; i < 3000; ++i) {
        std::string pattern, text;
        for (unsigned k = 0; k < 1 + random() % 4; ++k) {
            if (k > 0 && random() % 4 == 0) pattern += '|';
            pattern += kAtoms[random() % std::size(kAtoms)];
            pattern += kRepeats[random() % std::size(kRepeats)];
        }
        for (unsigned k = 0; k < random() % 6; ++k) text += random() % 2 == 0 ? 'a' : 'b';
        EXPECT_EQ(Regex(pattern).matches(text), std::regex_match(text, std::regex(pattern))) << pattern << " " << text;
    }
}

} // namespace
