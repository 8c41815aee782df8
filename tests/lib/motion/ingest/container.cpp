// Programs in binary G-code; projects are in tests/bats/ingest.bats.
#include "ingest/container.hpp"

#include "base/error.hpp"
#include "bgcode/file.hpp"
#include "read.hpp"

#include <gtest/gtest.h>

using namespace filum;

TEST(Container, TextIsItself) {
    std::string kept;
    Notes notes;
    const std::string text = "G1 X1\n";
    EXPECT_EQ(ingest::program_in(text, "test", 0, kept, notes).data(), text.data());
    EXPECT_THROW((void)ingest::program_in(text, "test", 1, kept, notes), Error);
    EXPECT_THROW((void)ingest::program_in(std::string("so\0lid", 6), "test", 0, kept, notes), Error);
}

// Line ends of three systems, padding behind the last one, and the mark of UTF-8, which hid the unit of the first line.
TEST(Container, LineEndsAndTheMarkOfUtf8DoNotMatter) {
    const std::string lines[] = {"G20", "G28", "; layer_height = 0.2", "G1 Z.01", "M83", "G1 X1 E.1", "", "G1 Y1 E.1"};
    double length = -1;
    for (const std::string mark : {"", "\xEF\xBB\xBF"})
        for (const std::string end : {"\n", "\r\n", "\r"}) {
            std::string bytes = mark, kept;
            for (const auto& line : lines) bytes += line + end;
            bytes += end == "\r" ? std::string(9, '\0') : "\x1a"; // padding of the last block, the end of DOS
            Notes notes;
            const auto r = ingested::read(std::string(ingest::program_in(bytes, "test", 0, kept, notes)));
            if (length < 0) length = ingested::length(r.spans);
            EXPECT_NEAR(ingested::length(r.spans), length, 1e-9);
        }
    EXPECT_NEAR(length, 2 * 25.4, 1e-9);
}

// The tables of binary G-code say what comments say in text: here the filament.
TEST(Container, BinaryGcodeIsItsTextWithItsSettings) {
    bgcode::File file;
    file.about = {{"Producer", "PrusaSlicer 2.8.1"}};
    file.slicer = {{"filament_diameter", "2.85"}, {"gcode_flavor", "marlin2"}};
    file.gcode = "M83\nG28 X Y\nG1 Z.2\nG0 X0 Y0\n;TYPE:Perimeter\nG1 X10 Y5 E.5\nM84 X Y E\n";
    std::string kept;
    Notes notes;
    const std::string bytes = bgcode::written(file);
    const auto text = ingest::program_in(bytes, "test", 0, kept, notes);
    EXPECT_NE(text.find("; filament_diameter = 2.85\n"), text.npos);
    const auto r = ingested::read(std::string(text));
    EXPECT_NEAR(ingested::volume(r.spans), 0.5 * ingested::kUnit * 2.85 * 2.85 / 1.75 / 1.75, 1e-9);
    EXPECT_EQ(r.spans.front().feature, toolpath::Feature::wall);
}
