#include "refusal.hpp"
#include "stressfield/frd_text.hpp"
#include "stressfield/read.hpp"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace filum::stressfield {
namespace {

std::string e12(double v) {
    char out[32];
    std::snprintf(out, sizeof out, "%12.5E", v);
    return out;
}

std::string record(int key, long long id, const std::vector<double>& v) {
    char out[32];
    std::snprintf(out, sizeof out, " %2d%10lld", key, id);
    std::string text = out;
    for (const double x : v) text += e12(x);
    return text + "\n";
}

std::string block(const char* key, std::size_t count) {
    char out[128];
    std::snprintf(out, sizeof out, "    %s                  %12zu%37s1\n", key, count, "");
    return out;
}

std::string result(int step, const std::string& name, const std::vector<std::string>& components,
                   const std::string& values) {
    char out[128];
    std::snprintf(out, sizeof out, "    1PSTEP              %12d%12d%12d\n", 1, 1, step);
    std::string text = out;
    std::snprintf(out, sizeof out, "  100CL  101 1.000000000%12d                     0%5d           1\n", 4, step);
    text += out;
    std::snprintf(out, sizeof out, " -4  %-8s%5zu    1\n", name.c_str(), components.size());
    text += out;
    for (const auto& c : components) text += " -5  " + c + "         1    4    1    1\n";
    return text + values + " -3\n";
}

const std::vector<std::string> kStress = {"SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"};

const std::string kHead = "    1C\n    1UUSER                                              \n";
std::string nodes() {
    return block("2C", 4) + record(-1, 10, {0, 0, 0}) + record(-1, 20, {1, 0, 0}) + record(-1, 30, {0, 1, 0}) +
           record(-1, 40, {0, 0, -1.5}) + " -3\n";
}
std::string elements(int type = 3, const std::string& list = "        10        20        30        40") {
    char out[64];
    std::snprintf(out, sizeof out, " -1%10d%5d    0    1\n", 1, type);
    return block("3C", 1) + out + " -2" + list + "\n -3\n";
}
std::string stresses(double factor = 1) {
    std::string out;
    for (int n = 1; n <= 4; ++n) out += record(-1, 10 * n, {factor * n, factor * -2, 3, factor * -4.5, -5e-9, 6});
    return out;
}
const std::string kEnd = " 9999\n";

Samples frd(const std::string& text, Notes* notes = nullptr, const std::string& step = "all") {
    Notes own;
    return read(text, "it", {.step = step}, notes != nullptr ? *notes : own);
}

std::string frd_fault(const std::string& text, Exit exit, const std::string& step = "all") {
    return refusal(exit, text, [&] { frd(text, nullptr, step); });
}

const std::string kDisplacements = result(1, "DISP", {"D1", "D2"}, record(-1, 10, {1, 2}) + record(-1, 20, {1, 2}));
const std::string kWhole = kHead + nodes() + elements() + kDisplacements + result(1, "STRESS", kStress, stresses()) +
                           result(1, "ERROR", {"STR(%)"}, record(-1, 10, {1})) +
                           result(2, "STRESS", kStress, stresses(10)) + kEnd;

TEST(Frd, NodesElementsAndStepsBesideOtherBlocks) {
    Notes notes;
    const auto s = frd(kWhole, &notes);
    ASSERT_EQ(s.points.size(), 4U);
    EXPECT_EQ(s.points[3], (Vec3{0, 0, -1.5}));
    ASSERT_EQ(s.elements.size(), 1U);
    EXPECT_EQ(s.elements[0].shape, Shape::tet4);
    EXPECT_EQ(s.nodes, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    ASSERT_EQ(s.cases.size(), 2U);
    EXPECT_EQ(s.cases[0].name, "1");
    EXPECT_EQ(s.cases[1].name, "2");
    EXPECT_EQ(s.cases[0].tensors[1], (Tensor{2, -2, 3, -4.5, -5e-9, 6}));
    EXPECT_EQ(s.cases[1].tensors[2], (Tensor{30, -20, 3, -45, -5e-9, 6}));
    EXPECT_TRUE(notes.empty());
}

TEST(Frd, OneStepOfSeveral) {
    const auto s = frd(kWhole, nullptr, "2");
    ASSERT_EQ(s.cases.size(), 1U);
    EXPECT_EQ(s.cases[0].tensors[0][0], 10);
    EXPECT_TRUE(has(frd_fault(kWhole, Exit::usage, "3"), "steps 1, 2"));
}

TEST(Frd, WindowsLineEndsGiveTheSame) {
    std::string dos;
    for (const char c : kWhole) dos += c == '\n' ? "\r\n" : std::string(1, c);
    const auto a = frd(kWhole), b = frd(dos);
    EXPECT_EQ(a.points, b.points);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.cases[1].tensors, b.cases[1].tensors);
}

TEST(Frd, ThreeDigitExponents) {
    // as C writes them: the negative ones a column wider
    std::string line =
        " -1        20" + e12(1e-100) + e12(-2e-100) + e12(3) + e12(-4.5) + e12(-5e-200) + e12(6e-300) + "\n";
    ASSERT_EQ(line.size(), 13U + 6 * 12 + 2 + 1);
    const std::string usual = record(-1, 20, {2, -2, 3, -4.5, -5e-9, 6});
    auto s = frd(with(kWhole, usual, line));
    EXPECT_EQ(s.cases[0].tensors[1], (Tensor{1e-100, -2e-100, 3, -4.5, -5e-200, 6e-300}));
    // without the E, in its columns
    line = " -1        20" + std::string(" 2.00000-100") + "-2.00000-102" + e12(3) + e12(-4.5) + e12(-5e-9) + e12(6) +
           "\n";
    s = frd(with(kWhole, usual, line));
    EXPECT_EQ(s.cases[0].tensors[1], (Tensor{2e-100, -2e-102, 3, -4.5, -5e-9, 6}));
}

TEST(Frd, NumbersOfEveryForm) {
    const auto value = [](const std::string& text) {
        double v = -1;
        EXPECT_TRUE(numbers(text, 0, 1, &v)) << text;
        return v;
    };
    for (const double v : {0.0, 1.0, -1.0, 1.23456e10, -9.87654e-13, 9.99999e-37, 1e-5, 123.456})
        EXPECT_EQ(value(e12(v)), std::strtod(e12(v).c_str(), nullptr));
    EXPECT_TRUE(std::isnan(value("         nan")));
    EXPECT_TRUE(std::isinf(value("        -inf")));
    EXPECT_EQ(value("         1.5"), 1.5);
    double v = 0;
    EXPECT_FALSE(numbers("            ", 0, 1, &v));
    EXPECT_FALSE(numbers(" ***********", 0, 1, &v));
    EXPECT_FALSE(numbers(" 1.0000E+00", 0, 1, &v)); // eleven columns
}

TEST(Frd, ShortFormAndNodesInAnyOrder) {
    std::string text = kHead +
                       "    2C                             2                                     0\n"
                       " -1    7" +
                       e12(1) + e12(2) + e12(3) + "\n -1    3" + e12(4) + e12(5) + e12(6) + "\n -3\n";
    text += "  100CL  101 1.000000000           2                     0    1           0\n -4  STRESS      6    1\n";
    for (const auto& c : kStress) text += " -5  " + c + "         1    4    1    1\n";
    text += " -1    3" + e12(1) + e12(0) + e12(0) + e12(0) + e12(0) + e12(0) + "\n -3\n 9999\n";
    const auto s = frd(text);
    ASSERT_EQ(s.points.size(), 2U);
    EXPECT_TRUE(std::isnan(s.cases[0].tensors[0][0])); // node 7 has none
    EXPECT_EQ(s.cases[0].tensors[1][0], 1);
}

TEST(Frd, WhatIsNotFiniteIsUnknownAndNoted) {
    Notes notes;
    const auto s = frd(with(kWhole, e12(2) + e12(-2), e12(std::nan("")) + e12(-2)), &notes);
    EXPECT_TRUE(std::isnan(s.cases[0].tensors[1][0]));
    ASSERT_EQ(notes.size(), 1U);
}

TEST(Frd, EveryCutIsSeen) {
    const std::size_t whole = kWhole.size() - kEnd.size();
    for (std::size_t size = 5; size < whole; ++size) {
        Notes notes;
        try {
            frd(kWhole.substr(0, size), &notes);
            EXPECT_FALSE(notes.empty()) << size;
        } catch (const Error& e) {
            EXPECT_TRUE(e.exit() == Exit::truncated || e.exit() == Exit::bad_input) << e.what();
        }
    }
    EXPECT_TRUE(has(frd_fault(kWhole.substr(0, 300), Exit::truncated), "inside"));
    EXPECT_TRUE(has(frd_fault(kWhole.substr(0, kWhole.size() - 100), Exit::truncated), "ends inside"));
}

TEST(Frd, FaultsAreNamed) {
    EXPECT_TRUE(has(frd_fault(kHead + nodes() + elements() + kDisplacements + kEnd, Exit::bad_input), "STRESS"));
    EXPECT_TRUE(has(frd_fault(kHead + kEnd, Exit::bad_input), "no nodes"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, "        20", "         20"), Exit::bad_input), "line 5"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, e12(-1.5), "-1.50000E+0"), Exit::bad_input), "12 columns"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, "    3C", "   3C "), Exit::bad_input), "no record"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, block("2C", 4), block("2C", 5)), Exit::bad_input), "announces 5 nodes"));
    EXPECT_TRUE(has(frd_fault(kHead + nodes() + elements(13) + kEnd, Exit::bad_input), "unknown type 13"));
    EXPECT_TRUE(has(frd_fault(kHead + nodes() + elements(6) + kEnd, Exit::bad_input), "4 nodes, not 10"));
    EXPECT_TRUE(has(
        frd_fault(kHead + nodes() + elements(3, "        10        20        30        50") + kEnd, Exit::bad_input),
        "node 50"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, "SXY", "SZX"), Exit::bad_input), "component"));
    EXPECT_TRUE(
        has(frd_fault(with(kWhole, "     1\n -1        10", "     2\n -1        10"), Exit::bad_input), "binary"));
    EXPECT_TRUE(
        has(frd_fault(with(kWhole, e12(0) + e12(0) + e12(-1.5), e12(0) + e12(0) + e12(std::nan(""))), Exit::bad_input),
            "finite"));
    EXPECT_TRUE(has(frd_fault(with(kWhole, "        40", "        10"), Exit::bad_input), "one number"));
}

TEST(Frd, BeamsAreOfNoUse) {
    const auto s =
        frd(kHead + nodes() + elements(11, "        10        20") + result(1, "STRESS", kStress, stresses()) + kEnd);
    EXPECT_TRUE(s.elements.empty());
    EXPECT_EQ(s.cases.size(), 1U);
}

TEST(Frd, TheLastIncrementOfAStepCounts) {
    Notes notes;
    const auto s = frd(kHead + nodes() + result(1, "STRESS", kStress, stresses()) +
                           result(1, "STRESS", kStress, stresses(3)) + kEnd,
                       &notes);
    ASSERT_EQ(s.cases.size(), 1U);
    EXPECT_EQ(s.cases[0].tensors[0][0], 3);
    ASSERT_EQ(notes.size(), 1U);
}

// A result of stresses with its increment or mode, as frdheader.c of CalculiX writes them.
std::string block_of(int step, int increment, int mode, double value, double factor) {
    char out[256];
    std::snprintf(out, sizeof out, "    1PSTEP              %12d%12d%12d\n", 1, increment, step);
    std::string text = out;
    if (mode > 0) {
        std::snprintf(out, sizeof out, "    1PMODE              %12d\n", mode);
        text += out;
    }
    std::snprintf(out, sizeof out,
                  "  100CL  101%12.5f%12d                     %d%5d           1\n -4  STRESS      6    1\n", value, 4,
                  mode > 0 ? 2 : 0, increment);
    text += out;
    for (const auto& c : kStress) text += " -5  " + c + "         1    4    1    1\n";
    return text + stresses(factor) + " -3\n";
}

TEST(Frd, IncrementsAndModesCanBeNamed) {
    const std::string text = kHead + nodes() + block_of(1, 1, 0, 0.5, 1) + block_of(1, 2, 0, 1, 2) +
                             block_of(2, 1, 1, 140.4, 3) + block_of(2, 1, 2, 220.5, 4) + block_of(3, 1, 0, 1, 5) + kEnd;
    const auto first = [&](const std::string& step) {
        const auto s = frd(text, nullptr, step);
        std::string out;
        for (const Case& c : s.cases) out += c.name + "=" + std::to_string(static_cast<int>(c.tensors[0][0])) + " ";
        return out;
    };
    EXPECT_EQ(first("all"), "1=2 2-mode1=3 2-mode2=4 3=5 ");
    EXPECT_EQ(first("1"), "1=2 ");
    EXPECT_EQ(first("1-1"), "1-1=1 ");
    EXPECT_EQ(first("1-2"), "1-2=2 ");
    EXPECT_EQ(first("2-mode1"), "2-mode1=3 ");
    EXPECT_EQ(first("3"), "3=5 ");
    const std::string fault = frd_fault(text, Exit::usage, "2"); // which of its modes?
    EXPECT_TRUE(has(fault, "1-1 (time 0.5), 1-2 (time 1), 2-mode1 (frequency 140.4), 2-mode2 (frequency 220.5), 3"));
    Notes notes;
    frd(text, &notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_TRUE(has(notes[0].detail, "1-1"));
}

} // namespace
} // namespace filum::stressfield
