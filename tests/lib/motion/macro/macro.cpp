// The macro language, construct by construct.
#include "macro/macro.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

namespace {

using namespace filum;
using macro::Value;
using macro::Variable;

Value whole(int v) { return static_cast<std::int64_t>(v); }

class Settings {
  public:
    Settings() {
        known["layer_height"] = Variable::one(0.2);
        known["perimeters"] = Variable::one(whole(3));
        known["complete"] = {false, {false}, {"0"}};
        known["fill_density"] = {false, {15.0}, {"15%"}};
        known["printer_notes"] = Variable::one(std::string("line one\nPRINTER_MODEL_X\nmore"));
        known["nozzle_diameter"] = Variable::many({0.4, 0.6});
        known["temperature"] = Variable::many({whole(215), whole(230)});
        known["filament_type"] = Variable::many({std::string("PLA"), std::string("PETG")});
        known["idle"] = Variable::many({Value{}, whole(100)});
        known["none"] = Variable::many({});
        known["initial_tool"] = Variable::one(whole(1));
        known["position"] = Variable::many({0.0, 0.0, 0.0});
    }

    std::string operator()(const std::string& text) {
        scope.find = [this](std::string_view name) -> const Variable* {
            const auto found = known.find(std::string(name));
            return found == known.end() ? nullptr : &found->second;
        };
        return macro::expand(macro::parsed("start_gcode", text), scope);
    }

    std::string wrong(const std::string& text) {
        try {
            return "no error: " + (*this)(text);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input);
            return e.what();
        }
    }

    std::map<std::string, Variable> known;
    macro::Scope scope;
};

TEST(Macro, TableOfConstructs) {
    const std::pair<const char*, const char*> kTable[] = {
        // text and brackets
        {"G28 ; home\n", "G28 ; home\n"},
        {"M104 S[temperature]", "M104 S215"},
        {"M104 S[temperature_1] [temperature_7]", "M104 S230 215"},
        {"M104 S[temperature[initial_tool]]", "M104 S230"},
        {"[fill_density] [complete] [layer_height]", "15% 0 0.2"},
        {"a } b", "a } b"},
        // numbers
        {"{1 + 2} {1.0 + 2} {7 / 2} {7 / 2.0} {7 % 4} {-7 / 2}", "3 3 3 3.5 3 -3"},
        {"{0.1 + 0.2} {1000000.0} {1234567.0} {0.00001} {-0.5}", "0.3 1e+06 1.23457e+06 1e-05 -0.5"},
        {"{temperature[-1]} {temperature[7]}", "215 215"},
        {"{temperature[0] - 5} {layer_height * 2} {nozzle_diameter[9]}", "210 0.4 0.4"},
        {"{2 + 3 * 4} {(2 + 3) * 4} {-(1 + 1)} {+3}", "14 20 -2 3"},
        // texts
        {"{\"a\" + 1 + 2} {1 + 2 + \"a\"} {\"x\\\"y\\\\\"}", "a12 3a x\"y\\"},
        {"{\"\" + ((filament_type[0] == \"PLA\") ? 1 : 2)}", "1"},
        // conditions
        {"{if perimeters > 2}many{else}few{endif}", "many"},
        {"{if perimeters == 1}one{elsif perimeters == 3}three{elsif true}other{endif}!", "three!"},
        {"{if false}a{elsif false}b{endif}c", "c"},
        {"{if true}{if false}x{else}y{endif}{endif}", "y"},
        {"{if not complete and !(perimeters < 3) or false}yes{endif}", "yes"},
        {"{if 1 <> 2 && 1 != 2 || false}yes{endif}", "yes"},
        {"{if 1 <= 1 and 2 >= 3}no{else}yes{endif}", "yes"},
        {"{if \"b\" > \"a\" and 1 < 1.5 and 0.1 + 0.2 == 0.3}yes{endif}", "yes"},
        {"{if false}{unknown}{nozzle_diameter}{endif}ok", "ok"},
        {"a{if true}\nb\n{endif}\nc", "a\nb\n\nc"},
        {"{if perimeters > 2 then \"a\"; \"b\" else \"c\" endif}", "ab"},
        {"{if perimeters > 5 then \"a\" elsif perimeters > 2 then \"b\"; endif; \"z\"}", "bz"},
        {"{true ? 1 : 2}{false ? 1 : true ? 2 : 3}", "12"},
        // regular expressions
        {"{if printer_notes =~ /.*PRINTER_MODEL_X.*/}yes{endif}", "yes"},
        {"{if printer_notes =~ /PRINTER_MODEL_X/}yes{else}the whole text must match{endif}",
         "the whole text must match"},
        {"{if filament_type[1] !~ /PLA|ABS/}yes{endif}", "yes"},
        {"{if \"a/b\" =~ /a\\/b/}yes{endif}", "yes"},
        // functions
        {"{min(1, 2)} {max(1, 2.5)} {min(3, 2.0)} {max(nozzle_diameter[0], nozzle_diameter[1])}", "1 2.5 2 0.6"},
        {"{int(2.9)} {int(-2.9)} {round(2.5)} {round(-2.5)} {floor(-0.5)} {ceil(0.5)} {abs(-3)}", "2 -2 3 -3 -1 1 3"},
        {"<{digits(5, 3)}><{zdigits(5, 3)}><{digits(3.14159, 6, 2)}><{zdigits(3.14159, 6, 2)}>",
         "<  5><005><  3.14><003.14>"},
        {"{is_nil(idle[0])} {is_nil(idle[1])} {size(idle)} {empty(none)} {empty(idle)}", "true false 2 true false"},
        {"{one_of(filament_type[0], \"ABS\", \"PLA\")} {one_of(\"x\", \"y\")} {one_of(\"PLA+\", /PLA.*/)}",
         "true false true"},
        {"{one_of(\"PLA+\", ~\"PLA.*\")}", "true"},
        {"{interpolate_table(5, (0, 0), (10, 100))} {interpolate_table(-1, (0, 7), (10, 100))} "
         "{interpolate_table(20, (0, 0), (10, 100))}",
         "50 7 100"},
        {"{exists(nothing)} {exists(perimeters)} {default_float(nothing, 2.5)} {default_int(perimeters, 1)}",
         "false true 2.5 3"},
        // variables
        {"{local a = 1 + 1}{a * 2}", "4"},
        {"{local a = 1; a = a + 1; local b = \"n\" + a}{b}", "n2"},
        {"{local v = (1, 2.5, \"x\")}{v[0]} {v[1]} {v[2]} {size(v)}", "1 2.5 x 3"},
        {"{local v = repeat(3, 7)}{v[2] = 8}{v[1]} {v[2]}", "7 8"},
        {"{local v = temperature; v[0] = 1}{v[0]} {v[1]} {temperature[0]}", "1 230 215"},
        {"{local x = (1 + 2) * 3}{x}", "9"},
        {"{position[2] = 5.5}{position[2]}", "5.5"},
        {"{perimeters; \"b\";}", "3b"},
    };
    for (const auto& [text, wanted] : kTable) {
        Settings settings;
        EXPECT_EQ(settings(text), wanted) << text;
    }
}

TEST(Macro, GlobalsStayFromTemplateToTemplate) {
    Settings s;
    EXPECT_EQ(s("{global n = 1}{local m = 5}"), "");
    EXPECT_EQ(s("{n = n + 1}{n}"), "2");
    EXPECT_NE(s.wrong("{m}").find("'m' is no known name"), std::string::npos);
}

TEST(Macro, FaultsNameTemplateLineAndColumn) {
    const std::pair<const char*, const char*> kTable[] = {
        {"G28\nM104 S{nothing}", "start_gcode: line 2, column 8: 'nothing' is no known name"},
        {"[nothing]", "line 1, column 1: 'nothing' is no known name"},
        {"G1\n  {nozzle_diameter}", "line 2, column 4: 'nozzle_diameter' is a list; say which of its values"},
        {"{layer_height[0]}", "'layer_height' is one value, not a list"},
        {"{none[0]}", "is an empty list"},
        {"{temperature[0.5]}", "an index must be a whole number"},
        {"{temperature[-1] = 1}", "below 0"},
        {"{if true}x", "'{endif}' is missing"},
        {"{if 1}x{endif}", "a condition must be true or false"},
        {"x{endif}", "'{endif}' has no '{if}' before it"},
        {"{1 +}", "a name is missing where a value should stand"},
        {"{1 / 0}", "division by zero"},
        {"{1 % 0}", "division by zero"},
        {"{\"a\" * 2}", "cannot calculate with a text and a whole number"},
        {"{true < false}", "cannot compare"},
        {"{1 and true}", "'and' and 'or' need conditions"},
        {"{not 1}", "'not' needs a condition"},
        {"{-\"a\"}", "cannot calculate with"},
        {"{\"open}", "its closing \" is missing"},
        {"{if \"a\" =~ /(/}x{endif}", "missing ): ("},
        {"{min(1)}", "min has 1 arguments; it takes 2"},
        {"{perimeters = 4}", "'perimeters' cannot be changed; it is a setting"},
        {"{new = 4}", "'new' is no known name; write 'local new = ...'"},
        {"{}", "a name is missing"},
        {"{perimeters", "'}' is missing"},
        {"{1 2}", "'}' is missing behind an expression"},
        {"{99999999999999999999}", "a number beyond all bounds"},
        {"{9000000000000000000 * 9}", "a number beyond all bounds"},
        {"{local v = (1, 2)}{v[2] = 1}", "'v' has 2 values; there is no number 2"},
        {"{local v = repeat(1000000, 1)}", "a list grows beyond 100000 values"},
        {"{random(2, 1)}", "random needs its lower bound first"},
        {"{is_nil(1)}", "is_nil needs a name in its brackets"},
    };
    for (const auto& [text, wanted] : kTable) {
        Settings settings;
        const std::string message = settings.wrong(text);
        EXPECT_NE(message.find(wanted), std::string::npos) << text << "\n" << message;
    }
}

TEST(Macro, DeepAndLongTemplatesEnd) {
    Settings s;
    EXPECT_NE(s.wrong("{" + std::string(100000, '(') + "1").find("nested too deep"), std::string::npos);
    EXPECT_NE(s.wrong("{" + std::string(100000, '-') + "1}").find("nested too deep"), std::string::npos);
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "{if true}";
    EXPECT_NE(s.wrong(deep).find("nested too deep"), std::string::npos);
    std::string doubled = "{local a = \"xxxxxxxxxxxxxxxx\"}";
    for (int i = 0; i < 64; ++i) doubled += "{a = a + a}";
    EXPECT_NE(s.wrong(doubled).find("16 MB"), std::string::npos);
    EXPECT_NE(s.wrong("{local a = \"" + std::string(10000, 'x') + "\"}{local v = repeat(100000, a)}").find("64 MB"),
              std::string::npos);
}

TEST(Macro, RandomIsTheSameForTheSameJob) {
    Settings a, b;
    EXPECT_EQ(a("{random(1, 1000000)} {random(0.0, 1.0)}"), b("{random(1, 1000000)} {random(0.0, 1.0)}"));
    for (int i = 0; i < 200; ++i) {
        const int v = std::stoi(a("{random(-2, 2)}"));
        EXPECT_TRUE(v >= -2 && v <= 2);
    }
}

TEST(Macro, OwnTemplatesHaveBracesAndPlainBrackets) {
    macro::Scope scope;
    const Variable v = Variable::one(1.5);
    scope.find = [&](std::string_view name) { return name == "a" ? &v : nullptr; };
    scope.numbers.decimals = 5;
    const auto expand = [&](const char* text) {
        return macro::expand(macro::parsed("templates.start", text, macro::Style::own), scope);
    };
    EXPECT_EQ(expand("x{a}{{a}} [b] {a * 1000000 + 0.000001}"), "x1.5{a} [b] 1500000");
    EXPECT_EQ(expand("{if a > 1}yes{endif}"), "yes");
    EXPECT_THROW((void)expand("a } b"), Error);
    EXPECT_THROW((void)expand("a { b"), Error);
}

// Templates made of pieces of the language in any order: each ends with a text or with an error of its own.
TEST(Macro, NoTemplateCrashesOrHangs) {
    const char* kPieces[] = {"{",          "}",          "[",           "]",       "(",
                             ")",          "if ",        "elsif ",      "else",    "endif",
                             "then ",      "local a = ", "global b = ", "a",       "temperature",
                             "perimeters", "[0]",        "1",           "2.5",     "\"x\"",
                             "+",          "-",          "*",           "/",       "%",
                             "<",          ">",          "=",           "==",      "!=",
                             "=~ /x*/",    "!~",         "and ",        "or ",     "not ",
                             "!",          "?",          ":",           ",",       ";",
                             "min(",       "max(",       "digits(",     "one_of(", "interpolate_table(",
                             "repeat(",    "is_nil(",    "size(",       "random(", "\n",
                             " ",          "G1 X",       "\\",          "/",       "~",
                             "{if true}",  "{else}",     "{endif}",     "nil",     "true",
                             "false",      "\xff",       "9999999999"};
    const char* count = std::getenv("FILUM_MACRO_CASES");
    const long cases = count == nullptr ? 20000 : std::atol(count);
    std::mt19937 random(7);
    for (long i = 0; i < cases; ++i) {
        std::string text;
        const std::size_t length = 1 + random() % 24;
        for (std::size_t k = 0; k < length; ++k) text += kPieces[random() % std::size(kPieces)];
        Settings s;
        try {
            (void)s(text);
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::bad_input) << text;
        }
    }
}

} // namespace
