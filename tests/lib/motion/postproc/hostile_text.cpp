// No text of a stream becomes a line of its own in a program, in any dialect.
#include "../../trials.hpp"

#include "postproc/about.hpp"
#include "postproc/measure.hpp"
#include "postproc/writer.hpp"

#include <cctype>
#include <gtest/gtest.h>
#include <random>
#include <regex>
#include <sstream>

namespace hostile_text {

using namespace filum;

// All that a stream can say about itself.
struct Texts {
    std::vector<postproc::LabelledPart> parts;
    std::vector<postproc::Stage> stages;
    Notes notes;
    Facts facts;
};

template <class Make>
Texts texts(geom::Vec2 centre, Make&& text) {
    const auto square = [&](double x) {
        const geom::Vec2 a{centre.x + x, centre.y};
        return std::vector<geom::Vec2>{a, {a.x + 2, a.y}, {a.x + 2, a.y + 2}, {a.x, a.y + 2}};
    };
    Texts out;
    out.parts = {{text(), square(-4)}, {text(), square(0)}, {text(), square(4)}};
    out.stages = {{text(), {{text(), text()}, {"a", text()}}}, {"postproc", {{"machine", text()}}}};
    out.notes = {{.amount = 3, .stage = text(), .foreign = {text(), text(), text()}},
                 {.code = NoteCode::component_dropped, .amount = 4, .count = 2, .detail = text(), .patch = text()}};
    out.facts = {{text(), text(), 3, text()}, {"sequence", text(), 4, ""}};
    return out;
}

std::string hostile(std::mt19937& random) {
    const std::string pieces[] = {"\n",
                                  "\r",
                                  "\r\n",
                                  "\xe2\x80\xa8",
                                  "\xc2\x85",
                                  "\n\nM112\n",
                                  "G28",
                                  ")",
                                  "(",
                                  ";",
                                  "!",
                                  "#",
                                  "\nEND\n",
                                  "py,exit",
                                  "logopen,a",
                                  "  P Y , exit",
                                  "'",
                                  "\"",
                                  "{x}",
                                  "{",
                                  "<!--",
                                  "</script>",
                                  "&",
                                  "\\n",
                                  "\xff",
                                  "MSG,wait",
                                  " probeclose",
                                  std::string(1, '\0'),
                                  "\x1b[2J",
                                  "%",
                                  "Gr\xc3\xb6sse",
                                  "NAME=",
                                  " M104 S999 ",
                                  std::string(120, ' '),
                                  std::string(99, 'x') + " logopen,b "};
    std::string out;
    for (unsigned n = 1 + random() % 5; n > 0; --n) {
        if (random() % 5 == 0)
            out += static_cast<char>(random());
        else
            out += pieces[random() % std::size(pieces)];
    }
    return out;
}

std::string program(const machine::Profile& p, const std::vector<toolpath::Span>& spans, const Texts& t) {
    postproc::Measure measure(p, postproc::Place::as_is);
    do
        for (const toolpath::Span& s : spans) measure.add(s);
    while (measure.again());
    auto first_pass = measure.end();
    first_pass.parts = t.parts;
    const geom::Vec2 shift = measure.program_shift();
    std::string out;
    const auto to = postproc::writer(p, first_pass, shift, [&](std::string_view text) { out += text; });
    to->begin(postproc::about(p, first_pass, postproc::summary(p, first_pass, shift, t.notes, t.facts), t.notes));
    const auto walk = postproc::walker(
        p, measure.walk_shift(), [&](auto steps) { to->add(steps); }, measure.joins());
    for (const toolpath::Span& s : spans) walk->add(measure.turned(s));
    walk->end();
    to->end(postproc::history(t.stages, t.notes, t.facts));
    return out;
}

// A comment that LinuxCNC acts on.
bool is_active(const std::string& comment) {
    static const std::regex kActive(
        "[ \t]*(m *s *g *,|debug *,|print *,|log *,|log(open|append|close)|probe(open|close)|"
        "p *y *,|py(run|reload)|abort *,).*",
        std::regex::icase);
    return std::regex_match(comment, kActive);
}

// The lines without comments and blanks at their ends, as a controller reads them: it takes any of CR, LF for an end.
std::vector<std::string> codes(const std::string& text, machine::CommentStyle style) {
    const char begin = ";(!#"[static_cast<std::size_t>(style)];
    std::vector<std::string> out;
    std::string code, comment;
    bool within = false;
    const auto end = [&] {
        EXPECT_FALSE(within && style == machine::CommentStyle::parentheses) << code << comment;
        EXPECT_FALSE(is_active(comment)) << comment;
        while (!code.empty() && code.back() == ' ') code.pop_back();
        if (!code.empty()) out.push_back(code);
        code.clear();
        comment.clear();
        within = false;
    };
    for (const char c : text) {
        if (c == '\n' || c == '\r') {
            end();
        } else if (within && style == machine::CommentStyle::parentheses && c == ')') {
            within = false;
        } else if (within) {
            EXPECT_FALSE(style == machine::CommentStyle::parentheses && c == '(') << comment;
            comment += c;
        } else if (c == begin) {
            within = true;
        } else {
            code += c;
        }
    }
    end();
    return out;
}

// A stroke in each of the three parts.
std::vector<toolpath::Span> path(const machine::Profile& p) {
    const geom::Vec2 c = p.bed.centre();
    const auto at = [&](double x, double y) { return geom::Vec3{c.x + x, c.y + y, 0.2}; };
    std::vector<toolpath::Span> out;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const double x = 4.0 * k - 4;
        if (k > 0) out.push_back({toolpath::Role::travel, k, 0, 0, {at(x - 4, 2), at(x, 0)}, {}, {}});
        out.push_back({toolpath::Role::bead, k, 0, 0, {at(x, 0), at(x + 1, 0), at(x + 1, 2), at(x, 2)}, {0.4}, {0.2}});
    }
    return out;
}

class HostileText : public testing::TestWithParam<std::string> {};

TEST_P(HostileText, IsNoCode) {
    machine::Profile p = machine::load_profile(GetParam());
    std::mt19937 random(11);
    for (const auto objects : {machine::Objects::none, machine::Objects::m486, machine::Objects::exclude_object}) {
        p.format.objects = objects;
        const auto spans = path(p);
        int word = 0;
        const std::string plain =
            program(p, spans, texts(p.bed.centre(), [&] { return "word" + std::to_string(word++); }));
        const auto good = codes(plain, p.format.comments);
        ASSERT_GT(good.size(), 5U);
        for (int trial = 0; trial < trials(20); ++trial) {
            const Texts t = texts(p.bed.centre(), [&] { return hostile(random); });
            const auto bad = codes(program(p, spans, t), p.format.comments);
            ASSERT_EQ(bad.size(), good.size()) << GetParam();
            for (std::size_t i = 0; i < good.size(); ++i) {
                if (bad[i] == good[i]) continue;
                // A name, where the language has one; it is a word.
                static const std::regex kName(
                    "(M486 A|EXCLUDE_OBJECT_(?:START|END|DEFINE) NAME=)([A-Za-z0-9_-]{1,70})(.*)");
                std::smatch a, b;
                ASSERT_TRUE(std::regex_match(good[i], a, kName)) << good[i];
                ASSERT_TRUE(std::regex_match(bad[i], b, kName)) << bad[i];
                EXPECT_EQ(a[1], b[1]);
                EXPECT_EQ(a[3], b[3]);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Profiles, HostileText, testing::ValuesIn(machine::profile_names()), [](const auto& about) {
    std::string name = about.param;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
});

TEST(HostileText, PartsKeepNamesOfTheirOwn) {
    const auto named = postproc::with_plain_names({{"a b", {}}, {"a\nb", {}}, {"", {}}, {"a_b_2", {}}, {"a-1", {}}});
    std::vector<std::string> names;
    for (const auto& part : named) names.push_back(part.name);
    EXPECT_EQ(names, (std::vector<std::string>{"a_b", "a_b_2", "part", "a_b_2_2", "a-1"}));
}

} // namespace hostile_text
