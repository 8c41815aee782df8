#include "app/filum/cura_formula.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace filum::app::filum {
namespace {

CuraValue setting(const std::string& name) {
    if (name == "height") return {0.2};
    if (name == "on") return {true};
    if (name == "word") return {std::string("lines")};
    return {MissingValue{"no file has '" + name + "'"}};
}

std::string result(const std::string& formula) {
    const CuraValue value = calculated(formula, setting);
    return value.known() ? text_of(value) : "? " + std::get<MissingValue>(value.as).why;
}

// The values were taken from Python 3.11.
TEST(CuraFormula, MeansWhatPythonMeans) {
    const std::pair<const char*, const char*> cases[] = {
        {"1 + 2 * 3 - 4 / 8", "6.5"},
        {"-2 ** 2", "-4"},
        {"2 ** 3 ** 2", "512"},
        {"7 // 2, 0", "? Filum cannot read it from ', 0' on"},
        {"-7 // 2", "-4"},
        {"-7 % 3", "2"},
        {"7.5 % -2", "-0.5"},
        {"round(2.5)", "2"},
        {"round(3.5)", "4"},
        {"round(2.675, 2)", "2.67"},
        {"round(height * 3, 4)", "0.6"},
        {"int(-2.7)", "-2"},
        {"math.ceil(round(0.8 / height, 4))", "4"},
        {"math.floor(math.degrees(math.atan(0.4 / 2.0 / height)))", "45"},
        {"1 if on else 0", "1"},
        {"1 if not on else 2 if word == 'lines' else 3", "2"},
        {"'zigzag' if height > 80 else 'triangles'", "triangles"},
        {"0 < height < 1", "1"},
        {"0 < height < 0.1", "0"},
        {"word in ['cross', 'lines']", "1"},
        {"word not in ['cross', 'cross_3d']", "1"},
        {"'in' in word", "1"},
        {"max(extruderValues('height')) * 2", "0.4"},
        {"sum(extruderValues('height')) / len(extruderValues('height'))", "0.2"},
        {"max(1, height, 0.5)", "1"},
        {"any([False, on])", "1"},
        {"resolveOrValue('height') + extruderValue(3, 'height')", "0.4"},
        {"int(defaultExtruderPosition())", "0"},
        {"[0, 90]", "[0, 90]"},
        {"[] if on else [20, 110]", "[]"},
        {"word or 'x'", "lines"},
        {"0 or 'x'", "x"},
        {"on and height", "0.2"},
        {"True + True", "2"},
        {"1e-1 + .5", "0.6"},
        {"'a' + \"b\"", "ab"},
        {R"('G28\nM84 \'x\'')", "G28\nM84 'x'"},
        {R"('\q')", R"(? Filum cannot read it from 'q'' on)"},
        {"5 if on else missing", "5"},
        {"on or missing", "1"},
        {"missing if on else 5", "? no file has 'missing'"},
        {"missing + 1", "? no file has 'missing'"},
        {"1 / 0", "? it divides by zero"},
        {"word * 2", "? it calculates with a word"},
        {"map(abs, [1])", "? no file has 'abs'"},
        {"hash(1)", "? it calls hash()"},
        {"10 ** 400", "? a number is beyond all bounds"},
        {"(1", "? its end is missing"},
        {"", "? its end is missing"},
        {"lambda x: x", "? Filum cannot read it from 'lambda x: x' on"},
    };
    for (const auto& [formula, value] : cases) EXPECT_EQ(result(formula), value) << formula;
}

// Random arithmetic beside the same in C++, with and without all brackets.
TEST(CuraFormula, RandomArithmetic) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 3000; ++trial) {
        const auto digit = [&] { return static_cast<double>(random() % 9 + 1); };
        double value = digit(), term = value, sum = 0; // the sum of what stands before the last term
        std::string text = std::to_string(static_cast<int>(value));
        for (int k = 0; k < 6; ++k) {
            const double next = digit();
            const char sign = "+-*/"[random() % 4];
            text += std::string(random() % 2, ' ') + sign + std::string(random() % 2, ' ') +
                    std::to_string(static_cast<int>(next));
            if (sign == '+' || sign == '-') {
                sum += term;
                term = sign == '+' ? next : -next;
            } else {
                term = sign == '*' ? term * next : term / next;
            }
        }
        const CuraValue out = calculated(text, setting);
        ASSERT_TRUE(out.known()) << text;
        EXPECT_NEAR(std::get<double>(out.as), sum + term, 1e-9 * (1 + std::abs(sum + term))) << text;
    }
}

// Random texts of the formulas' words: each has a value or a reason, and none takes long.
TEST(CuraFormula, AnyTextIsReadOrRefused) {
    const char* words[] = {"(",      ")",    "[",   "]",   ",",     "+",    "-",   "*",     "/",
                           "%",      "<",    "==",  "if ", "else ", "not ", "in ", "and ",  "or ",
                           "height", "word", "'a'", "\"",  "1.5",   "1e",   "max", "round", "math.pi"};
    std::mt19937 random(5);
    for (int trial = 0; trial < 20000; ++trial) {
        std::string text;
        for (auto n = random() % 14; n > 0; --n) text += words[random() % std::size(words)];
        const CuraValue value = calculated(text, setting);
        EXPECT_TRUE(value.known() || !std::get<MissingValue>(value.as).why.empty()) << text;
    }
    for (const char* deep : {"(", "[", "-", "not ", "1 if 1 else ", "max(", "2 ** ", "2 ** -"}) {
        std::string text;
        for (int i = 0; i < 100000; ++i) text += deep;
        EXPECT_FALSE(calculated(text, setting).known());
    }
}

// Settings that double a text or a list, one on top of the other, do not fill the memory.
TEST(CuraFormula, ValuesThatDoubleEnd) {
    for (const char* formula :
         {"last + last", "[last, last]", "[last] + [last]", "max([last, last]) + last", "[str(last), str(last)]"}) {
        CuraValue last{std::string("word")};
        int steps = 0;
        while (last.known() && steps < 60)
            last = calculated(formula, [&](const std::string&) { return last; }), ++steps;
        EXPECT_FALSE(last.known()) << formula;
        EXPECT_LT(steps, 20) << formula;
    }
}

} // namespace
} // namespace filum::app::filum
