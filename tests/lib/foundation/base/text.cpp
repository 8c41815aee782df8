#include "base/json.hpp"
#include "base/nearest.hpp"
#include "base/printable.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace filum {
namespace {

TEST(Nearest, DistancesAreAMetricOfSingleSlips) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("marlin", "marlin"), 0U);
    EXPECT_EQ(edit_distance("", "abc"), 3U);
    EXPECT_EQ(edit_distance("marln", "marlin"), 1U);
    EXPECT_EQ(edit_distance("mralin", "marlin"), 1U); // two neighbours swapped
    EXPECT_EQ(edit_distance("merlin", "marlin"), 1U);
    std::mt19937 random(7);
    const auto word = [&] {
        std::string out;
        for (std::size_t n = random() % 7; out.size() < n;) out += static_cast<char>('a' + random() % 3);
        return out;
    };
    for (int i = 0; i < 500; ++i) {
        const std::string a = word(), b = word();
        const std::size_t d = edit_distance(a, b);
        EXPECT_EQ(d, edit_distance(b, a)) << a << " " << b;
        EXPECT_EQ(d == 0, a == b);
        EXPECT_LE(d, std::max(a.size(), b.size()));
        EXPECT_GE(d, std::max(a.size(), b.size()) - std::min(a.size(), b.size()));
    }
}

TEST(Nearest, SuggestsWhatIsNearAndNothingElse) {
    const std::vector<std::string> names{"layer-height", "first-layer-height", "bead-width", "spacing", "q"};
    EXPECT_EQ(nearest("layerheight", names), "layer-height");
    EXPECT_EQ(nearest("bead-witdh", names), "bead-width");
    EXPECT_EQ(nearest("width", names), "bead-width"); // a part of only one
    EXPECT_EQ(nearest("height", names), "");          // a part of two
    EXPECT_EQ(nearest("temperature", names), "");
    EXPECT_EQ(nearest("", names), "");
    EXPECT_EQ(nearest(std::string(1000, 'a'), names), "");
    EXPECT_EQ(did_you_mean("spacng", names, "--"), "; did you mean '--spacing'?");
    EXPECT_EQ(did_you_mean("temperature", names), "");
}

TEST(Printable, KeepsTextAndShowsCodes) {
    EXPECT_EQ(printable("plain text, 3 mm"), "plain text, 3 mm");
    EXPECT_EQ(printable("Gr\xc3\xb6\xc3\x9f"
                        "e \xe2\x82\xac \xf0\x9f\x99\x82"),
              "Gr\xc3\xb6\xc3\x9f"
              "e \xe2\x82\xac \xf0\x9f\x99\x82");
    EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\rd");
    EXPECT_EQ(printable("\x1b[2J\x07\x7f"), "\\x1b[2J\\x07\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\xc2\\x9b"
              "31m"); // C1: the one-byte start of a sequence
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "gpj"),
              "\\xe2\\x80\\xae"
              "gpj"); // turns the writing round
    EXPECT_EQ(printable("\xc0\xaf \xed\xa0\x80 \xe2\x82"), "\\xc0\\xaf \\xed\\xa0\\x80 \\xe2\\x82"); // no UTF-8
}

TEST(Printable, NoControlByteIsEverLeft) {
    std::mt19937 random(11);
    for (int i = 0; i < 2000; ++i) {
        std::string text;
        for (std::size_t n = random() % 20; text.size() < n;) text += static_cast<char>(random() % 256);
        for (const char c : printable(text)) {
            EXPECT_GE(static_cast<unsigned char>(c), 0x20);
            EXPECT_NE(c, 0x7f);
        }
        EXPECT_EQ(printable(printable(text)), printable(text));
    }
}

TEST(PlainWord, IsAWordForEveryText) {
    EXPECT_EQ(plain_word("bench-y_2", "part"), "bench-y_2");
    EXPECT_EQ(plain_word("a b\nM112", "part"), "a_b_M112");
    EXPECT_EQ(plain_word("", "part"), "part");
    EXPECT_EQ(plain_word(std::string(1000, 'x'), "part").size(), 64U);
}

TEST(Json, TextIsAlwaysUtf8) {
    EXPECT_EQ(json_text("Gr\xc3\xb6\xc3\x9f"
                        "e \"a\"\n"),
              "\"Gr\xc3\xb6\xc3\x9f"
              "e \\\"a\\\"\\u000a\"");
    EXPECT_EQ(json_text("a\xff\xc3"), "\"a\\ufffd\\ufffd\"");
}

} // namespace
} // namespace filum
