// Lines of programs that are passed over, followed, reported or refused.
#include "base/error.hpp"
#include "read.hpp"

#include <gtest/gtest.h>
#include <random>

using namespace filum;
using ingested::kUnit;
using ingested::read;

namespace {

// The error's text, or "" if the program is read.
std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        return e.what();
    }
    return "";
}

} // namespace

TEST(Ingest, RefusesLoopsJumpsAndSubprograms) {
    const std::string bead = "G28\nG1 Z0.2\nM83\nG1 X1 E1\n";
    for (const std::string line : {"WHILE [#1 LT 5] DO1", "while iterations < 5", "GOTO 10", "IF [#1 EQ 0] GOTO 20",
                                   "M98 P100", "M98 P1000 L3", "o100 call"})
        EXPECT_NE(refusal(bead + line + "\n" + bead), "") << line;
    for (const std::string line : {"M98 P\"homez.g\"", "if !move.axes[0].homed", "M99", "O1000", "IF_HOT T=200"})
        EXPECT_EQ(refusal(bead + line + "\n" + bead), "") << line;
}

// O-words of LinuxCNC: a label alone names the program; with a keyword it controls the flow.
TEST(Ingest, RefusesOWordsWithAKeyword) {
    const std::string bead = "G28\nG1 Z0.2\nM83\nG1 X1 E1\n";
    for (const std::string label : {"o100", "O1", "O <twice>", "o<twice>", "N20 o<a b>", "o[#1 + 2]"}) {
        EXPECT_EQ(refusal(bead + label + "\n" + bead), "") << label;
        for (const std::string keyword :
             {"sub", "endsub", "call", "call [1] [2.5]", "call[1]", "while [#1 LT 3]", "do", "repeat [5]", "endrepeat",
              "if [#1 EQ 0]", "elseif [1]", "else", "endif", "break", "continue", "return [#1]"})
            for (const std::string blank : {"", " ", "\t"})
                EXPECT_NE(refusal(bead + label + blank + keyword + "\n" + bead).find("line 5 calls or repeats"),
                          std::string::npos)
                    << label << blank << keyword;
    }
}

// Places by parameters and formulas are refused, also on lines that move by an earlier G1.
TEST(Ingest, RefusesParametersForPlaces) {
    const std::string begin = "G28\nG1 Z0.2\nM83\nG1 X1 E1\n";
    for (const std::string line : {"G1 X#1", "X#1", "X[1+2]", "Y#<way>", "E#3", "x[#2] e1", "X", "A#1", "G1 A[2]"})
        EXPECT_NE(refusal(begin + line + "\n"), "") << line;
    EXPECT_EQ(refusal(begin + "#1=5\n#<way> = [#1 * 2]\nG28 X\nG92 E0\n"), "");
}

TEST(Ingest, RefusesMovesUnderACondition) {
    const std::string bead = "G28\nG1 Z0.2\nM83\nG1 X1 E1\n";
    EXPECT_NE(refusal(bead + "if {move.axes[2].homed}\n  G1 X9 E1\n").find("condition"), std::string::npos);
    EXPECT_NE(refusal(bead + "if true\n  if false\n    M117 a\n  G1 X9 E1\n").find("condition"), std::string::npos);
    EXPECT_NE(refusal(bead + "if true\n  M117 a\nelse\n  G1 X9 E1\n").find("condition"), std::string::npos);
    EXPECT_EQ(refusal(bead + "if true\n  M117 a\nG1 X9 E1\n"), "");
    EXPECT_EQ(refusal(bead + "  G1 X9 E1\n"), "");
}

// Codes that make the following lines other moves than they say, and what they look like.
TEST(Ingest, RefusesCodesThatChangeLaterMoves) {
    const std::string bead = "G28\nG1 Z0.2\nM83\nG1 X1 E1\n";
    for (const std::string line :
         {"G2.2 X1 Y1 I1 J1 R2", "G3.4 X1 Y2 Z3", "G6.2 P4 K0 X1 Y1 R1", "G54.1 P3", "G54.4 P1", "G65 P9010 A1",
          "G66 P9010", "G70", "G700", "G71 P10 Q20 X1", "G50 X100 Z50", "G60 X10", "M97 P100", "M198 P10", "M808 L5",
          "SET_GCODE_OFFSET X=5 MOVE=1", "set_gcode_offset y_adjust=.2"})
        EXPECT_NE(refusal(bead + line + "\n" + bead), "") << line;
    for (const std::string line : {"G50", "G60 S1", "G71", "G43.1 Z-12", "G93", "G94", "G95", "M808", "G54",
                                   "SET_GCODE_OFFSET Z_ADJUST=.02", "SET_GCODE_OFFSET X=0 Y=0"})
        EXPECT_EQ(refusal(bead + line + "\n" + bead), "") << line;
}

// G93 and G95 say what F means; no place depends on it.
TEST(Ingest, FeedsByTimeChangeNoPlace) {
    const std::string begin = "G28\nM83\nG1 Z0.2\nG0 X10 Y10\n", bead = "G1 X30 E1 F600\nX40 Y20 E1 F900\n";
    const auto plain = read(begin + bead), inverse = read(begin + "G93\n" + bead + "G94\n" + bead);
    EXPECT_EQ(plain.spans[0].points[1].x, inverse.spans[0].points[1].x);
    EXPECT_DOUBLE_EQ(ingested::volume(inverse.spans), 2 * ingested::volume(plain.spans));
}

// States that the firmware stores and restores: modes, and with MOVE=1 the place.
TEST(Ingest, RestoresStoredStates) {
    const std::string begin = "G28\nM83\nG1 Z0.2\nG0 X10 Y10\n", bead = "G1 X30 Y10 E1\n";
    const auto length = [&](const std::string& between) {
        return ingested::length(read(begin + between + bead).spans);
    };
    EXPECT_DOUBLE_EQ(length(""), 20);
    for (const auto& [save, back] :
         {std::pair<std::string, std::string>{"SAVE_GCODE_STATE NAME=a", "RESTORE_GCODE_STATE NAME=a"},
          {"save_gcode_state name=\"a b\"", "Restore_Gcode_State name=\"a b\""},
          {"M120", "M121"}})
        EXPECT_DOUBLE_EQ(length(save + "\nG91\nG0 X5\n" + back + "\n"), 15) << save;
    EXPECT_DOUBLE_EQ(length("SAVE_GCODE_STATE NAME=a\nG91\nG0 X5\nRESTORE_GCODE_STATE NAME=a MOVE=1\n"), 20);
    EXPECT_DOUBLE_EQ(length("RESTORE_GCODE_STATE NAME=never\nM121\n"), 20);
}

TEST(Ingest, RefusesWhatItDoesNotUnderstand) {
    EXPECT_NE(refusal("G1 X\nG1 X1 E1").find("line 1 holds a word without a proper number"), std::string::npos);
    EXPECT_NE(refusal("G1 Z1\nG5 X1 E1\n").find("line 2 asks for G5"), std::string::npos);
    EXPECT_NE(refusal("X1 E1\n").find("before any G0 or G1"), std::string::npos);
    EXPECT_NE(refusal("G1 X1 E1\n").find("unknown height"), std::string::npos); // at z = 0
    EXPECT_NE(refusal("G1 X1\n").find("cannot find a bead"), std::string::npos);
    EXPECT_NE(refusal("").find("cannot find a bead"), std::string::npos);
}

// For any text: an answer or an error of bad input, in finite time.
TEST(Ingest, SurvivesAnyText) {
    std::mt19937 random(11);
    const std::string letters = "GXYZEIJRMTFP0123456789.-+; (\n\n\n)";
    for (int k = 0; k < 2000; ++k) {
        std::string text = "M83\nG1 Z0.2\nG1 X1 E1\n";
        for (int i = 0; i < 120; ++i) text += letters[random() % letters.size()];
        try {
            const auto r = read(text);
            for (const auto& s : r.spans) EXPECT_GE(s.points.size(), 2u);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
        }
    }
}

namespace {

constexpr const char* kBegin = "G21\nG90\nM83\nG28\nG1 Z.2\nG0 X10 Y10\n";
constexpr const char* kBead = "G1 X30 Y10 E1\nG1 X30 Y30 E1\n"; // 40 mm

} // namespace

// Commands that do not move are passed over, however their words look.
TEST(Ingest, FlagsAndTextOfCommandsAreNoWords) {
    for (const char* line : {"M84 X Y E",
                             "M569 S1 X Y",
                             "G28 XY",
                             "G28 W",
                             "G29 G",
                             "G29 P1 X0 Y0 W50 H20 C",
                             "M117 G1 X99 E9",
                             "Tx",
                             "T?",
                             "T-1",
                             "T1000",
                             "M104 S200 T1",
                             "SET_VELOCITY_LIMIT ACCEL=3000",
                             "print_start EXTRUDER=215",
                             "M486 AName X5 Y",
                             "M862.3 P \"MK3S\"",
                             "G5",
                             "G80",
                             "G4 S",
                             "M23 /A/B.GCO",
                             "N5 M84 X Y",
                             "G92 E0",
                             "G10 S215 P0",
                             "G10 L2 P1",
                             "M220 S100",
                             "G43 H1",
                             "G64 P0.01",
                             "G54",
                             "O1234",
                             "Start GCode begin"}) {
        const auto r = read(std::string(kBegin) + line + "\nG0 X10 Y10 Z.2\n" + kBead + line);
        EXPECT_NEAR(ingested::length(r.spans), 40, 1e-9) << line;
        EXPECT_EQ(r.found.counts.strokes, 1u) << line;
        EXPECT_EQ(r.found.counts.retractions, 0u) << line;
        for (const auto& s : r.spans) EXPECT_EQ(s.tool, 0u) << line;
    }
    EXPECT_EQ(read(std::string(kBegin) + "T1\n" + kBead).spans.front().tool, 1u);
    EXPECT_EQ(read(std::string(kBegin) + "T1 M6\n" + kBead).spans.front().tool, 1u);
}

// What moves, or turns what moves, in a way that is not followed is refused by its name.
TEST(Ingest, RotaryAxesAndTurnedCoordinatesAreRefused) {
    for (const char letter : {'A', 'B', 'C', 'U', 'V', 'W'}) {
        const std::string line = std::string("G1 X40 ") + letter + "10 E1\n";
        EXPECT_NE(refusal(std::string(kBegin) + kBead + line).find(std::string("moves the axis ") + letter),
                  std::string::npos);
    }
    for (const char* code : {"G43.4 H1",
                             "G43.5",
                             "G68 X0 Y0 R30",
                             "G68.2 X0 Y0 Z0 I10",
                             "G51 X2",
                             "G16",
                             "G12.1",
                             "G41 D1",
                             "M128",
                             "G5 X1 Y1 I2 J2",
                             "G81 X1 Y1 Z-1 R1",
                             "G18\nG2 X5 Z1 I1 K1 E1",
                             "O100 call",
                             "M605 S2",
                             "G7",
                             "G92.3",
                             "G1 X1 X2 E1",
                             "G1 X1..2",
                             "G1 X#1",
                             "G"})
        EXPECT_NE(refusal(std::string(kBegin) + kBead + code + "\n" + kBead).find("line "), std::string::npos) << code;
    EXPECT_NE(refusal(std::string(kBegin) + "G43.4\n" + kBead).find("G43.4"), std::string::npos);
}

TEST(Ingest, OriginsAreFollowed) {
    const auto place = [](const std::string& text) {
        const auto r = read(std::string(kBegin) + text + "\nG1 E1 X5 Y5");
        return r.spans.back().points.back();
    };
    const auto expect = [&](const std::string& text, double x, double y) {
        EXPECT_NEAR(place(text).x, x, 1e-9) << text;
        EXPECT_NEAR(place(text).y, y, 1e-9) << text;
    };
    expect("", 5, 5);
    expect("G92 X0 Y0", 15, 15);
    expect("G92 X0 Y0\nG92.1", 5, 5);
    expect("G92 X0 Y0\nG53 G0 X0 Y0", 15, 15); // of that line only
    expect("G53 G1 X40", 5, 5);
    expect("G52 X100", 105, 5);
    expect("G10 L2 P1 X100 Y20", 105, 25);
    expect("G10 L2 P2 X100\nG55", 105, 5);
    expect("G10 L20 P1 X0 Y0", 15, 15);
    expect("G10 L2 P1 X7\nG92 X0\nG52 X1", 16, 5); // G92 names the place 10 as 0, G52 adds 1
    const auto r = read(std::string(kBegin) + "G10 L2 P1 X100\n" + kBead);
    EXPECT_EQ(r.found.counts.retractions, 0u);
    EXPECT_EQ(r.found.notes.size(), 1u);
    EXPECT_NE(refusal(std::string(kBegin) + kBead + "G55\n" + kBead).find("G55"), std::string::npos);
    const auto told = std::string("G10 L2 P1 X0\nG10 L2 P2 X3\n");
    EXPECT_EQ(refusal(std::string(kBegin) + told + kBead + "G55\n" + kBead), "");
}

TEST(Ingest, FlowAndLinesThatAreNoCommandsAreReported) {
    const auto r = read(std::string(kBegin) + "M221 S50\n=====\n" + kBead);
    ASSERT_EQ(r.found.notes.size(), 2u);
    EXPECT_NEAR(r.found.notes[0].amount, 0.5 * 2 * kUnit, 1e-9);
    EXPECT_EQ(r.found.notes[1].count, 1u);
}
