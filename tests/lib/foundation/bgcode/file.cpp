// Binary G-code: what is written comes back, what is damaged is refused.
#include "bgcode/file.hpp"

#include "base/error.hpp"
#include "bgcode/heatshrink.hpp"
#include "bgcode/meatpack.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace filum;

namespace {

// As programs are, and not at all as they are.
std::string sample(std::mt19937& random, std::size_t lines) {
    const auto any = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    std::string out;
    for (std::size_t i = 0; i < lines; ++i) switch (any(8)) {
        case 0:
            out += ";TYPE:Perimeter GX 0\n";
            break;
        case 1:
            out += "M117 Hello G X" + std::to_string(any(99)) + "\n";
            break;
        case 2:
            out += "EXCLUDE_OBJECT_END NAME=e_" + std::to_string(any(5)) + "\n";
            break;
        default:
            out += "G1X" + std::to_string(any(9999)) + "." + std::to_string(any(10)) + "Y-" + std::to_string(any(300)) +
                   "E." + std::to_string(any(100000)) + "\n";
        }
    return out;
}

} // namespace

TEST(Heatshrink, WhatIsShrunkExpandsAgain) {
    std::mt19937 random(3);
    for (int k = 0; k < 300; ++k) {
        const unsigned letters = 1 + random() % 256;
        std::string data(random() % 6000, '\0');
        for (char& c : data) c = static_cast<char>(random() % letters);
        for (const int window : {11, 12}) {
            const std::string small = bgcode::shrunk(data, window, 4);
            EXPECT_EQ(bgcode::expanded(small, data.size(), window, 4), data);
            EXPECT_LE(small.size(), data.size() + data.size() / 8 + 1);
        }
    }
}

TEST(Heatshrink, DamagedDataIsNone) {
    EXPECT_FALSE(bgcode::expanded("", 1, 12, 4));
    EXPECT_FALSE(bgcode::expanded(std::string(3, '\0'), 1, 12, 4)); // points before the begin
    EXPECT_EQ(bgcode::expanded("", 0, 12, 4), "");
    // 'a', then 3 from one back: 1 01100001 0 00000000000 0010
    EXPECT_EQ(bgcode::expanded(std::string("\xb0\x80\x01\x00", 4), 4, 11, 4), "aaaa");
}

TEST(MeatPack, LinesComeBack) {
    EXPECT_EQ(bgcode::unpacked(bgcode::packed("G1 X10 Y2.5 E.1 ; away\n\n; kept G X\nM84 X Y E\n")),
              "G1X10Y2.5E.1\n; kept G X\nM84 X Y E\n");
    // both characters of a byte, the first, the second in full
    EXPECT_EQ(bgcode::unpacked("\xff\xff\xfb\xff"
                               "ab"
                               "\x1f"
                               "c"
                               "\xf2"
                               "d"),
              "abc12d");
    std::mt19937 random(4);
    for (int k = 0; k < 200; ++k) {
        const std::string text = sample(random, random() % 60);
        EXPECT_EQ(bgcode::unpacked(bgcode::packed(text)), text);
    }
}

TEST(BinaryGcode, FilesComeBackAndDamageIsSeen) {
    std::mt19937 random(5);
    bgcode::File file;
    file.about = {{"Producer", "Filum"}};
    file.printer = {{"printer_model", "MK4"}};
    for (int i = 0; i < 200; ++i) file.slicer.emplace_back("key" + std::to_string(i), "value = " + std::to_string(i));
    file.thumbnails = {{bgcode::Picture::png, 16, 9, std::string("\x89PNG\0x", 6)}};
    file.gcode = sample(random, 9000); // several blocks
    const std::string bytes = bgcode::written(file);
    EXPECT_LT(bytes.size(), file.gcode.size() / 2);
    const bgcode::File back = bgcode::read(bytes, "test");
    EXPECT_EQ(back.gcode, file.gcode);
    EXPECT_EQ(back.about, file.about);
    EXPECT_EQ(back.slicer, file.slicer);
    ASSERT_EQ(back.thumbnails.size(), 1u);
    EXPECT_EQ(back.thumbnails[0].bytes, file.thumbnails[0].bytes);
    EXPECT_EQ(back.thumbnails[0].height, 9);
    for (int k = 0; k < 300; ++k) {
        std::string bad = bytes;
        const std::size_t at = random() % bad.size();
        if (k % 2 == 0)
            bad.resize(at);
        else
            bad[at] = static_cast<char>(bad[at] ^ (1 << (random() % 8)));
        try {
            const auto other = bgcode::read(bad, "test");
            // cut between two blocks: the format does not say how many there are
            EXPECT_TRUE(k % 2 == 0 && file.gcode.starts_with(other.gcode)) << at;
        } catch (const Error& e) {
            EXPECT_TRUE(e.exit() == Exit::bad_input || e.exit() == Exit::truncated);
        }
    }
}
